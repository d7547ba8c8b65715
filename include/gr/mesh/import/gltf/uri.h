// Where a glTF file's buffers are: in its own text, or in a file below its own folder.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gr::importer {

bool isDataUri(std::string_view uri);
// The bytes in a data: uri, or nothing where it is broken.
std::optional<std::string> dataOf(std::string_view uri);
// The path of a file, in the form that OtherFile takes, or nothing where it would not be below the folder.
std::optional<std::string> pathOf(std::string_view uri);

}  // namespace gr::importer
