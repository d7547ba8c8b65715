// Objects of JSON text that know where they stand, so that what is wrong with one can be told by its place.
#pragma once

#include "gr/mesh/import/source_mesh.h"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string_view>

namespace gr::importer {

// Throws Failure, with line and column, where the text is no JSON or is nested so deep that no glTF file is. A
// byte order mark before it is skipped, and so are zero bytes that fill up behind it.
nlohmann::json parseJson(std::string_view text);

// Keys that are absent give nothing or what the caller names; values of another type than asked for throw Failure.
// What it looks at must outlive it.
class JsonObject {
public:
    // place: such as "node 3", or "" for the whole file.
    JsonObject(const nlohmann::json& value, std::string place);

    const std::string& place() const { return place_; }
    // The beginning of a sentence about it: "its node 3", or "it".
    std::string subject() const { return place_.empty() ? "it" : "its " + place_; }
    // The same about what it has under a key: "its node 3's "mesh"".
    std::string subjectOf(std::string_view key) const;

    std::vector<std::string> keys() const;
    const nlohmann::json* find(const char* key) const;  // or null
    std::optional<JsonObject> object(const char* key) const;
    std::optional<JsonObject> extension(const char* name) const;
    // An empty one where there is none.
    const nlohmann::json& list(const char* key) const;
    std::optional<std::uint64_t> whole(const char* key) const;
    std::uint64_t whole(const char* key, std::uint64_t otherwise) const { return whole(key).value_or(otherwise); }
    std::uint64_t neededWhole(const char* key) const;
    bool flag(const char* key) const;
    std::string text(const char* key) const;
    // Empty where there are none. count: how many there must be; 0: any number of them.
    std::vector<double> numbers(const char* key, std::size_t count = 0) const;

private:
    [[noreturn]] void failType(const char* key, const char* wanted) const;

    const nlohmann::json* value_;
    std::string place_;
};

// A whole number that is not negative, be it written as 3 or as 3.0.
std::optional<std::uint64_t> wholeNumber(const nlohmann::json& value);

}  // namespace gr::importer
