#include "grsh/commands.h"
#include "grsh/option_words.h"
#include "grsh/redefine.h"

#include <array>

namespace grsh {
namespace {

// The commands that take options.
struct OptionTable {
    std::string_view command;
    std::vector<OptionHelp> (*options)();
};
constexpr std::array<OptionTable, 8> optionTables{{
    {"gr_render", renderOptionsHelp},
    {"gr_compare", compareOptionsHelp},
    {"gr_polyhedron", polyhedronOptionsHelp},
    {"gr_mesh", meshOptionsHelp},
    {"gr_texture", textureOptionsHelp},
    {"gr_light", lightOptionsHelp},
    {"gr_sun", sunOptionsHelp},
    {"gr_material", materialOptionsHelp},
}};

// Words that are neither commands nor options in pairs.
struct Topic {
    std::string_view name, text;
};
constexpr std::array<Topic, 2> otherTopics{{
    {"#auto",
     "#auto in place of the name of a node, a material, a texture or a light:\n"
     "the command's name without its gr_ and the next number with which it is free, e.g. sphere1\n"
     "the command returns what it has made, e.g. gr_translate [gr_sphere : #auto] {0 1 0}"},
    {redefineOption,
     "gr_material -redefine name ..., gr_light -redefine name ..., gr_sun -redefine name ...:\n"
     "makes another of one that there is, for all that name it"},
}};

std::string oneLineEach() {
    std::string text;
    for (const Command* command : allCommands()) {
        std::string line(command->name);
        line.resize(20, ' ');
        text += line + std::string(command->help) + "\n";
    }
    return text + "gr_help command says more, e.g. gr_help gr_render";
}

// Those of one type of material or texture behind a line that names it.
std::string listOf(const std::vector<OptionHelp>& options) {
    std::string text;
    std::string_view type;
    for (const OptionHelp& option : options) {
        if (option.type != type) text += "\ntype " + std::string(option.type) + ":";
        type = option.type;
        text += "\n" + option.text;
    }
    return text;
}

std::string about(const Command& command) {
    std::string text = std::string(command.name);
    if (!command.usage.empty()) text += " " + std::string(command.usage);
    text += "\n" + std::string(command.help);
    if (!command.details.empty()) text += "\n" + std::string(command.details);
    if (!command.alias.empty()) text += "\nolder name: " + std::string(command.alias);
    for (const OptionTable& table : optionTables)
        if (command.name == table.command)
            text += "\noptions, with or without a leading dash:" + listOf(table.options());
    return text;
}

// Of every command, every type of material or texture and every option of that name; empty where there is none.
std::string aboutWord(std::string_view name) {
    const std::string_view word = withoutDash(name);
    if (word.empty()) return "";
    std::string text;
    const auto add = [&](const std::string& lines) { text += (text.empty() ? "" : "\n") + lines; };
    for (const Command* command : allCommands())
        if (name == command->name || name == command->alias || name == command->name.substr(3)) add(about(*command));
    for (const Topic& topic : otherTopics)
        if (word == withoutDash(topic.name)) add(std::string(topic.text));
    for (const OptionTable& table : optionTables) {
        std::vector<OptionHelp> ofType;
        for (OptionHelp& option : table.options())
            if (!option.type.empty() && option.type == name) ofType.push_back(std::move(option));
        if (!ofType.empty())
            add(std::string(table.command) + " name " + std::string(name) +
                " ?option value ...?, with or without a leading dash:" + listOf(ofType));
    }
    for (const OptionTable& table : optionTables)
        for (const OptionHelp& option : table.options())
            if (word == option.name || word == option.alias)
                add("option of " + std::string(table.command) +
                    (option.type.empty() ? "" : ", type " + std::string(option.type)) + ":\n" + option.text);
    return text;
}

// All that something is known of.
std::vector<std::string_view> topics() {
    std::vector<std::string_view> names;
    for (const Command* command : allCommands()) {
        names.push_back(command->name);
        if (!command->alias.empty()) names.push_back(command->alias);
    }
    for (const Topic& topic : otherTopics) names.push_back(topic.name);
    for (const OptionTable& table : optionTables) {
        for (const OptionHelp& option : table.options()) {
            names.push_back(option.name);
            if (!option.type.empty()) names.push_back(option.type);
        }
    }
    return names;
}

Tcl_Obj* help(Call& call) {
    if (call.words.size() == 0) return textObject(oneLineEach());
    const std::string_view name = call.words.text(0);
    if (const std::string text = aboutWord(name); !text.empty()) return textObject(text);
    throw core::Error("COMMAND", "UNKNOWN", std::string(name),
                      std::string("no such command") + (name.starts_with("gr_") ? " " : ", type or option ") +
                          quoted(name) + core::didYouMean(name, topics()));
}

constexpr std::array<Command, 1> rows{{
    {"gr_help", "", "?word?", 0, 1, help,
     "returns what the commands do, or what is known of a command, a type of material or texture, or an option"},
}};

}  // namespace

std::span<const Command> helpCommands() {
    return rows;
}

}  // namespace grsh
