#include "grsh/error_place.h"

#include <cstdlib>
#include <map>
#include <optional>
#include <vector>

#include "grsh/error_info.h"
#include "grsh/piped_script.h"
#include "grsh/place.h"
#include "grsh/script_text.h"

namespace grsh {
namespace {

// {file line} of a procedure's or a method's body. The trace has the name as it was called, so it is looked for in
// every namespace; the one whose text has the command on that line is meant.
constexpr const char* kFindBody = R"tcl({unit line command} {
    lassign $unit kind name what method
    set bodies {}
    if {$kind eq "procedure"} {
        set pattern [string map {* \\* ? \\? [ \\[ ] \\] \\ \\\\} $name]
        regsub {\.\.\.$} $pattern * pattern
        for {set spaces {{}}} {[llength $spaces]} {lappend spaces {*}[namespace children ${space}::]} {
            set spaces [lassign $spaces space]
            foreach procedure [info procs ${space}::[string trimleft $pattern :]] {
                lappend bodies [list proc $procedure]
            }
        }
    } elseif {$kind eq "class"} {
        lappend bodies [list method $name $method]
    } elseif {$kind eq "object"} {
        lappend bodies [list objmethod $name $method]
    }
    set start [lindex [split $command \n] 0]
    foreach body $bodies {
        if {[catch {::tcl::unsupported::getbytecode {*}$body} code]} continue
        if {![dict exists $code sourcefile]} continue
        if {[string first $start [lindex [split [dict get $code script] \n] $line-1]] < 0} continue
        return [list [dict get $code sourcefile] [dict get $code initiallinenumber]]
    }
})tcl";

std::vector<std::string> listWords(const std::string& text) {
    int count = 0;
    const char** words = nullptr;
    if (Tcl_SplitList(nullptr, text.c_str(), &count, &words) != TCL_OK) return {};
    std::vector<std::string> result(words, words + count);
    Tcl_Free(reinterpret_cast<char*>(words));
    return result;
}

// Goes through a trace from the outermost command inwards and keeps the place of the last that stands in a file.
class Walk {
public:
    explicit Walk(Tcl_Interp* interp) : interp(interp) {}

    void enter(const ErrorLevel& level) {
        const ErrorUnit unit = level.units.empty() ? ErrorUnit{} : level.units.back();
        if (unit.name.starts_with("file "))
            enterFile(level, inWhole({fileOf(unit), unit.line}));
        else if (const std::optional<Place> body = bodyOf(unit, level.command))
            enterBody(level, *body);
        else
            enterWord(level);
    }

    std::optional<Place> innermost;

private:
    struct Enclosing {
        std::string path;
        CommandSpan span;
    };

    const ScriptText* script(const std::string& path) {
        auto [entry, isNew] = scripts.try_emplace(path);
        if (isNew) entry->second = readScript(path);
        return entry->second ? &*entry->second : nullptr;
    }

    void found(const std::string& path, const CommandSpan& span) {
        innermost = {path, span.line()};
        enclosing.push_back({path, span});
    }

    // The command's line in the word of another that it stood in, or 0.
    static int wordLine(const ErrorLevel& level) { return level.units.empty() ? 0 : level.units.front().line; }

    // Most often the command is on the line that Tcl has. Not so when "try", which the trace leaves out, or "catch" and
    // "return" at a file's top level passed the error on: the line is then the one in their word.
    void enterFile(const ErrorLevel& level, const Place& place) {
        const std::string& path = place.path;
        if (path.empty() || isLibrary(interp, path)) return;
        innermost = place;
        const ScriptText* text = script(path);
        if (!text) return;
        const std::size_t begin = text->startOf(place.line);
        const bool isPassedOn = level.units.size() > 1;
        std::optional<CommandSpan> span;
        if (!isPassedOn) span = commandOnLine(*text, begin, 1, level);
        if (!span) span = commandWithin({text, 0, text->text.size()}, wordLine(level), level);
        if (span) found(path, *span);
    }

    void enterBody(const ErrorLevel& level, const Place& body) {
        if (isLibrary(interp, body.path)) return;
        const int line = level.units.back().line;
        innermost = {body.path, body.line + line - 1};
        const ScriptText* text = script(body.path);
        if (!text) return;
        const auto span = commandOnLine(*text, text->startOf(body.line), line, level);
        if (span) found(body.path, *span);
    }

    // A word of a command further out, e.g. a loop's body. A lambda or a constructor, which Tcl does not place, may be
    // anywhere in the script; a script put together at run time has no place.
    void enterWord(const ErrorLevel& level) {
        for (auto outer = enclosing.rbegin(); outer != enclosing.rend(); ++outer)
            if (findIn(outer->path, outer->span, level)) return;
        const std::string_view unit = level.units.empty() ? "" : std::string_view(level.units.back().name);
        if (enclosing.empty() || !(unit.starts_with("lambda ") || unit.starts_with("class "))) return;
        const ScriptText* text = enclosing.back().span.script;
        findIn(enclosing.back().path, {text, 0, text->text.size()}, level);
    }

    bool findIn(const std::string& path, const CommandSpan& outer, const ErrorLevel& level) {
        const auto span = commandWithin(outer, wordLine(level), level);
        if (span) found(path, *span);
        return span.has_value();
    }

    // Empty where Tcl has cut a long name. The outermost file is the main script, whose name is known.
    std::string fileOf(const ErrorUnit& unit) {
        const std::vector<std::string> words = listWords(unit.name);
        const std::string name = words.size() == 2 ? words[1] : "";
        if (name.size() < 150 || !name.ends_with("...")) return normalized(name);
        const MainScript* main = mainScript(interp);
        return main && !innermost ? main->path : "";
    }

    std::optional<Place> bodyOf(const ErrorUnit& unit, const std::string& command) {
        const Value answer = ask(interp, {"apply", kFindBody, unit.name, std::to_string(unit.line), command});
        const std::vector<std::string> words = answer ? listWords(stringOf(answer.get())) : std::vector<std::string>();
        if (words.size() != 2) return std::nullopt;
        return inWhole({normalized(words[0]), std::atoi(words[1].c_str())});
    }

    Tcl_Interp* interp;
    std::map<std::string, std::optional<ScriptText>> scripts;
    std::vector<Enclosing> enclosing;
};

}  // namespace

std::string errorPlace(Tcl_Interp* interp) {
    const std::string message = stringOf(Tcl_GetObjResult(interp));
    const Value options = hold(Tcl_GetReturnOptions(interp, TCL_ERROR));
    Tcl_Obj* trace = nullptr;
    Tcl_DictObjGet(nullptr, options.get(), textValue("-errorinfo").get(), &trace);
    if (!trace) return "";
    const KeptState kept(interp);
    const std::vector<ErrorLevel> levels = errorLevels(stringOf(trace), message);
    Walk walk(interp);
    for (auto level = levels.rbegin(); level != levels.rend(); ++level) walk.enter(*level);
    return walk.innermost ? shown(interp, *walk.innermost) : "";
}

}  // namespace grsh
