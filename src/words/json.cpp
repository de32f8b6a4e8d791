#include "words/json.hpp"

#include <nlohmann/json.hpp>

#include "words/printed.hpp"

namespace dumbbell {
namespace {

/// In ASCII alone, whatever bytes a name in it has.
std::string dumped(const nlohmann::ordered_json& json, int indent) {
    return json.dump(indent, ' ', true, nlohmann::ordered_json::error_handler_t::replace);
}

constexpr int on_one_line = -1;

/// The one place that spells an integer. Every integer below 2^53 is a double.
std::string spelled(const Count& value) {
    const Count limit(Integer(1) << 53);
    const bool is_double = value < limit && Count(0) - value < limit;
    return is_double ? value.str() : '"' + value.str() + '"';
}

}  // namespace

Json::Json(std::nullptr_t /*null*/) : text_("null") {}
Json::Json(bool value) : text_(value ? "true" : "false") {}
Json::Json(int value) : text_(std::to_string(value)) {}
Json::Json(long value) : text_(spelled(value)) {}
Json::Json(unsigned long value) : text_(spelled(value)) {}
Json::Json(const Count& value) : text_(spelled(value)) {}
Json::Json(double value) : text_(dumped(value, on_one_line)) {}
Json::Json(std::string_view value) : text_(dumped(value, on_one_line)) {}
Json::Json(const std::string& value) : Json(std::string_view(value)) {}
Json::Json(const char* value) : Json(std::string_view(value)) {}

Json Json::object(std::initializer_list<Member> members) {
    Json json;
    json.text_ = "{}";
    for (const auto& [name, value] : members) {
        json.add(name, value);
    }
    return json;
}

Json Json::array(std::initializer_list<Json> values) {
    Json json;
    json.text_ = "[]";
    for (const Json& value : values) {
        json.add(value);
    }
    return json;
}

void Json::reopen() {
    text_.pop_back();
    if (text_.size() > 1) {
        text_ += ',';
    }
}

void Json::add(std::string_view name, const Json& value) {
    reopen();
    text_.append(1, '"').append(name).append("\":").append(value.text_).append(1, '}');
}

void Json::add(const Json& value) {
    reopen();
    text_.append(value.text_).append(1, ']');
}

std::string json_text(const Json& json) {
    return dumped(nlohmann::ordered_json::parse(json.text()), 2) + '\n';
}

Json ends_json(const Interval& x) { return Json::array({unsigned_zero(x.lo()), unsigned_zero(x.hi())}); }

}  // namespace dumbbell
