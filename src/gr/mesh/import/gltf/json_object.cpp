#include "gr/mesh/import/gltf/json_object.h"

#include "gr/mesh/import/gltf/words.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace gr::importer {
namespace {

using nlohmann::json;

const json emptyList = json::array();

// How far the text is right is all that the parser tells well.
std::string whereIn(std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, byte > 0 ? byte - 1 : 0);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t column = before.size() - (before.rfind('\n') + 1) + 1;
    return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

// The parser would tell the depth, too, but then looks through a whole list after each of its items.
void refuseDeep(std::string_view text) {
    constexpr int mostLevels = 64;
    int level = 0;
    bool isInText = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (isInText && c == '\\')
            ++i;
        else if (c == '"')
            isInText = !isInText;
        else if (!isInText && (c == '[' || c == '{') && ++level > mostLevels)
            throw Failure("its JSON is nested deeper than 64 levels");
        else if (!isInText && (c == ']' || c == '}'))
            --level;
    }
}

}  // namespace

json parseJson(std::string_view text) {
    refuseDeep(text);
    try {
        return json::parse(text.begin(), text.end());
    } catch (const json::parse_error& error) {
        throw Failure("it is not whole JSON text: it goes wrong at " + whereIn(text, error.byte));
    } catch (const json::out_of_range&) {
        throw Failure("its JSON has a number that is too large for any computer number");
    }
}

std::optional<std::uint64_t> wholeNumber(const json& value) {
    if (value.is_number_unsigned()) return value.get<std::uint64_t>();
    if (!value.is_number_float()) return {};
    const double number = value.get<double>();
    constexpr double most = 9007199254740992;  // beyond it not all whole numbers are doubles
    if (!(number >= 0 && number <= most && number == std::floor(number))) return {};
    return static_cast<std::uint64_t>(number);
}

JsonObject::JsonObject(const json& value, std::string place) : value_(&value), place_(std::move(place)) {
    if (!value.is_object()) throw Failure((place_.empty() ? "its JSON" : "its " + place_) + " is not an object");
}

std::string JsonObject::subjectOf(std::string_view key) const {
    return (place_.empty() ? "its " : "its " + place_ + "'s ") + inQuotes(key);
}

void JsonObject::failType(const char* key, const char* wanted) const {
    throw Failure(subjectOf(key) + " is not " + wanted);
}

std::vector<std::string> JsonObject::keys() const {
    std::vector<std::string> keys;
    for (const auto& item : value_->items()) keys.push_back(item.key());
    return keys;
}

const json* JsonObject::find(const char* key) const {
    const auto at = value_->find(key);
    return at == value_->end() ? nullptr : &*at;
}

std::optional<JsonObject> JsonObject::object(const char* key) const {
    const json* value = find(key);
    if (value == nullptr) return {};
    return JsonObject(*value, place_.empty() ? key : place_ + "'s " + key);
}

std::optional<JsonObject> JsonObject::extension(const char* name) const {
    const std::optional<JsonObject> all = object("extensions");
    if (!all || all->find(name) == nullptr) return {};
    return JsonObject(*all->find(name), place_ + "'s " + name);
}

const json& JsonObject::list(const char* key) const {
    const json* value = find(key);
    if (value == nullptr) return emptyList;
    if (!value->is_array()) failType(key, "a list");
    return *value;
}

std::optional<std::uint64_t> JsonObject::whole(const char* key) const {
    const json* value = find(key);
    if (value == nullptr) return {};
    const std::optional<std::uint64_t> number = wholeNumber(*value);
    if (!number) failType(key, "a whole number from 0");
    return number;
}

std::uint64_t JsonObject::neededWhole(const char* key) const {
    const std::optional<std::uint64_t> number = whole(key);
    if (!number) throw Failure(subject() + " has no " + inQuotes(key));
    return *number;
}

bool JsonObject::flag(const char* key) const {
    const json* value = find(key);
    if (value != nullptr && !value->is_boolean()) failType(key, "true or false");
    return value != nullptr && value->get<bool>();
}

std::string JsonObject::text(const char* key) const {
    const json* value = find(key);
    if (value == nullptr) return "";
    if (!value->is_string()) failType(key, "a text");
    return value->get<std::string>();
}

std::vector<double> JsonObject::numbers(const char* key, std::size_t count) const {
    std::vector<double> numbers;
    for (const json& value : list(key)) {
        if (!value.is_number()) failType(key, "a list of numbers");
        numbers.push_back(value.get<double>());
    }
    if (count > 0 && find(key) != nullptr && numbers.size() != count)
        throw Failure(subjectOf(key) + " has " + std::to_string(numbers.size()) + " numbers instead of " +
                      std::to_string(count));
    return numbers;
}

}  // namespace gr::importer
