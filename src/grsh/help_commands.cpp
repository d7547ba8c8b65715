#include "grsh/commands.h"

#include <array>

namespace grsh {
namespace {

std::string oneLineEach() {
    std::string text;
    for (const Command* command : allCommands()) {
        std::string line(command->name);
        line.resize(20, ' ');
        text += line + std::string(command->help) + "\n";
    }
    return text + "gr_help command says more, e.g. gr_help gr_render";
}

std::string about(const Command& command) {
    std::string text = std::string(command.name);
    if (!command.usage.empty()) text += " " + std::string(command.usage);
    text += "\n" + std::string(command.help);
    if (!command.details.empty()) text += "\n" + std::string(command.details);
    if (!command.alias.empty()) text += "\nolder name: " + std::string(command.alias);
    std::string options;
    if (command.name == "gr_render") options = renderOptionsHelp();
    if (command.name == "gr_compare") options = compareOptionsHelp();
    if (command.name == "gr_polyhedron") options = polyhedronOptionsHelp();
    if (command.name == "gr_mesh") options = meshOptionsHelp();
    if (command.name == "gr_material") options = materialOptionsHelp();
    if (!options.empty()) {
        options.pop_back();
        text += "\noptions, with or without a leading dash:\n" + options;
    }
    return text;
}

Tcl_Obj* help(Call& call) {
    if (call.words.size() == 0) return textObject(oneLineEach());
    const std::string_view name = call.words.text(0);
    std::vector<std::string_view> names;
    for (const Command* command : allCommands()) {
        if (name == command->name || (!name.empty() && name == command->alias)) return textObject(about(*command));
        names.push_back(command->name);
        if (!command->alias.empty()) names.push_back(command->alias);
    }
    throw core::Error("COMMAND", "UNKNOWN", std::string(name),
                      "no such command " + quoted(name) + core::didYouMean(name, names));
}

constexpr std::array<Command, 1> rows{{
    {"gr_help", "", "?command?", 0, 1, help, "returns what the commands do, or how one is used"},
}};

}  // namespace

std::span<const Command> helpCommands() {
    return rows;
}

}  // namespace grsh
