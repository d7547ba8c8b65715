// Words of a file in messages to a person.
#pragma once

#include <string>
#include <string_view>

namespace gr::importer {

// In quotation marks, on one line, and not too long.
std::string inQuotes(std::string_view text);

}  // namespace gr::importer
