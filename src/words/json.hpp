#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "number/count.hpp"
#include "number/interval.hpp"

namespace dumbbell {

/// A value as JSON, made from the inside out and kept as text: the library that knows how strings and numbers
/// are spelled is in one source file, not in every one that reports.
class Json {
  public:
    /// A field: its name, plain ASCII, and its value.
    struct Member;

    // NOLINTBEGIN(google-explicit-constructor): a value is what it is in JSON, too
    Json(std::nullptr_t = nullptr);
    Json(bool value);
    /// An integer is a string from 2^53 on (of either sign): most readers of JSON keep numbers in doubles.
    Json(int value);
    Json(long value);
    Json(unsigned long value);
    Json(const Count& value);
    /// Null if it is not finite.
    Json(double value);
    /// What is no UTF-8 becomes U+FFFD.
    Json(std::string_view value);
    Json(const std::string& value);
    Json(const char* value);
    /// Null for what is not known.
    template <class T>
    Json(const std::optional<T>& value) : Json(value ? Json(*value) : Json()) {}
    // NOLINTEND(google-explicit-constructor)

    /// The fields in the order that they are given.
    [[nodiscard]] static Json object(std::initializer_list<Member> members = {});
    [[nodiscard]] static Json array(std::initializer_list<Json> values = {});
    template <class Values>
    [[nodiscard]] static Json array(const Values& values) {
        Json array = Json::array();
        for (const auto& value : values) {
            array.add(value);
        }
        return array;
    }

    /// Another field of an object.
    void add(std::string_view name, const Json& value);
    /// Another value of an array.
    void add(const Json& value);

    /// On one line without spaces, in ASCII.
    [[nodiscard]] const std::string& text() const { return text_; }

  private:
    /// Opens an object or array again, for another field or value.
    void reopen();

    std::string text_;
};

struct Json::Member {
    std::string_view name;
    Json value;
};

/// An object as `--json` prints it: indented, a field a line.
[[nodiscard]] std::string json_text(const Json& json);

/// The ends of an enclosure, exactly, as a pair of numbers.
[[nodiscard]] Json ends_json(const Interval& x);

}  // namespace dumbbell
