#include "grsh/overrides.h"

#include "grsh/option_words.h"
#include "grsh/render_job.h"
#include "image/image_file.h"

namespace grsh {
namespace {

[[noreturn]] void fail(const std::string& word, const std::string& message) {
    throw core::Error("USAGE", "SET", word, "--set " + message);
}

}  // namespace

Overrides::Overrides(const std::vector<std::string>& assignments) : isAny_(!assignments.empty()) {
    for (const std::string& assignment : assignments) {
        const std::size_t equals = assignment.find('=');
        if (equals == std::string::npos) fail(assignment, "needs option=value, not " + grsh::quoted(assignment));
        try {
            set(assignment.substr(0, equals), argumentValue(assignment.substr(equals + 1)).get());
        } catch (const core::Error& error) {
            fail(error.word, assignment + ": " + error.what());
        }
    }
}

std::vector<std::string_view> Overrides::names() {
    std::vector<std::string_view> names{"file", "width", "height"};
    for (const auto& row : render::RenderSettings::options()) names.push_back(row.name);
    return names;
}

void Overrides::set(const std::string& name, Tcl_Obj* value) {
    if (name == "file") {
        file_ = fileNameFrom(value, "file");
        image::checkEndingToWrite(*file_);
    } else if (name == "width" || name == "height") {
        (name == "width" ? width_ : height_) = integerFrom(value, name, pixelRange);
    } else {
        const auto* row = findOption(render::RenderSettings::options(), name);
        if (row == nullptr)
            throwNoOption<render::RenderSettings>(name, "no such option of gr_render", {"file", "width", "height"});
        render::RenderSettings anything;
        readOption(*row, value, anything);
        options_.emplace_back(row, hold(value));
    }
}

void Overrides::apply(RenderJob& job) {
    areUsed_ = true;
    if (isFileTaken_)
        throw core::Error("FILE", "TWICE", *file_,
                          "--set file=" + *file_ +
                              " has the picture of an earlier gr_render, which this one would replace: where a script "
                              "renders more than one, they need names of their own");
    if (file_) job.file = *file_;
    if (width_) job.width = *width_;
    if (height_) job.height = *height_;
    for (const auto& [row, value] : options_) {
        readOption(*row, value.get(), job.settings);
        // A file that is named outside of all scripts lies where grsh was started.
        if (row->name == "environment") job.settings.environmentPath = job.settings.environment;
    }
}

}  // namespace grsh
