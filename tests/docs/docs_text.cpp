// The parts of the documentation that the code knows best. In its file each stands between two lines,
//     <!-- generated: NAME -->
//     <!-- end -->
// docs_text ROOT writes what lies between them; docs_text --check ROOT fails where that is not what the code has.
#include "core/option.h"
#include "grsh/commands.h"
#include "image/compare.h"
#include "materials/material.h"
#include "render/settings.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace {
namespace fs = std::filesystem;

// A | would end a table's cell, in backquotes too.
std::string cell(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '|') escaped += '\\';
        escaped += c;
    }
    return escaped;
}

std::string code(std::string_view text) {
    return "`" + cell(text) + "`";
}

std::string commandTable(const fs::path&) {
    std::string text = "| command | what it does |\n| --- | --- |\n";
    for (const grsh::Command* command : grsh::allCommands()) {
        const std::string words = command->usage.empty() ? "" : " " + std::string(command->usage);
        text += "| " + code(std::string(command->name) + words);
        if (!command->alias.empty()) text += " (older name " + code(command->alias) + ")";
        text += " | " + cell(command->help) + " |\n";
    }
    return text;
}

template<class Owner>
std::string optionTable(std::span<const core::OptionRow<Owner>> rows) {
    std::string text = "| option | value | default | meaning |\n| --- | --- | --- | --- |\n";
    for (const auto& row : rows) {
        std::string value = code(core::typeText(row));
        if (const std::string range = core::rangeText(row.range); !range.empty()) value += " " + range;
        if (!row.unit.empty()) value += ", " + std::string(row.unit);
        text += "| " + code(row.name);
        if (!row.alias.empty()) text += " (also " + code(row.alias) + ")";
        text += " | " + value + " | " + code(core::defaultText(row)) + " | " + cell(row.help) + " |\n";
    }
    return text;
}

std::string materialTables(const fs::path&) {
    std::string text;
    materials::forEachMaterialType([&]<class M>() {
        if (!text.empty()) text += "\n";
        text += "Type `" + std::string(M::typeName) + "`:\n\n" + optionTable(M::options());
    });
    return text;
}

std::string textureTables(const fs::path&) {
    std::string text;
    materials::forEachTextureType([&]<class T>() {
        if (!text.empty()) text += "\n";
        text += "Type `" + std::string(T::typeName) + "`:\n\n" + optionTable(T::options());
    });
    return text;
}

std::string renderTable(const fs::path&) {
    return optionTable(render::RenderSettings::options());
}

std::string compareTable(const fs::path&) {
    return optionTable(image::CompareSettings::options());
}

std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) throw std::runtime_error("cannot read " + path.string());
    return text.str();
}

std::string smallestScene(const fs::path& root) {
    return "```tcl\n" + read(root / "scenes/hello.gr") + "```\n";
}

// To add one: its row here, and its two lines in the file.
struct Part {
    const char* file;
    const char* name;
    std::string (*text)(const fs::path& root);
};
constexpr std::array<Part, 6> parts{{
    {"README.md", "scenes/hello.gr", smallestScene},
    {"docs/language.md", "commands", commandTable},
    {"docs/language.md", "texture options", textureTables},
    {"docs/language.md", "material options", materialTables},
    {"docs/language.md", "render options", renderTable},
    {"docs/language.md", "compare options", compareTable},
}};

// The file's text with the part as the code has it.
std::string withPart(const std::string& old, const Part& part, const fs::path& root) {
    const std::string begin = "<!-- generated: " + std::string(part.name) + " -->\n";
    const std::size_t at = old.find(begin);
    const std::size_t end = at == old.npos ? old.npos : old.find("<!-- end -->\n", at);
    if (end == old.npos)
        throw std::runtime_error(std::string(part.file) + " has no lines \"<!-- generated: " + part.name +
                                 " -->\" and, behind it, \"<!-- end -->\"");
    return old.substr(0, at + begin.size()) + part.text(root) + old.substr(end);
}

bool isUpToDate(const Part& part, const fs::path& root, bool write) {
    const std::string old = read(root / part.file);
    const std::string now = withPart(old, part, root);
    if (now == old) return true;
    if (!write) {
        std::printf("%s: \"%s\" is not what the code has; tools/docs brings it up to date\n", part.file, part.name);
        return false;
    }
    std::ofstream file(root / part.file, std::ios::binary);
    file << now << std::flush;
    if (!file) throw std::runtime_error("cannot write " + (root / part.file).string());
    std::printf("%s: \"%s\" rewritten\n", part.file, part.name);
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    const bool check = argc == 3 && std::string_view(argv[1]) == "--check";
    if (argc != 2 && !check) {
        std::fputs("usage: docs_text [--check] ROOT\n", stderr);
        return 2;
    }
    try {
        bool good = true;
        for (const Part& part : parts) good &= isUpToDate(part, argv[argc - 1], !check);
        return good ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "docs_text: %s\n", error.what());
        return 1;
    }
}
