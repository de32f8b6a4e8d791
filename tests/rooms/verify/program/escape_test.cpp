// Text for JSON, XML and one line: each well-formed character stays, what is none becomes U+FFFD byte by
// byte.
#include "verify/program/escape.hpp"

#include "catch.hpp"

using namespace dumbbell_verify;

namespace {

const std::string replacement = "\xef\xbf\xbd";  // U+FFFD

std::string times(std::size_t n, const std::string& text) {
    std::string result;
    while (n-- > 0) result += text;
    return result;
}

}  // namespace

TEST_CASE("escape: the first and the last character of each length stay") {
    for (const std::string character :
         {" ", "~", "\xc2\xa0", "\xdf\xbf", "\xe0\xa0\x80", "\xec\xbf\xbf", "\xed\x80\x80", "\xed\x9f\xbf",
          "\xee\x80\x80", "\xef\xbe\xbf", "\xef\xbf\x80", "\xef\xbf\xbd", "\xf0\x90\x80\x80",
          "\xf0\xbf\xbf\xbf", "\xf1\x80\x80\x80", "\xf3\xbf\xbf\xbf", "\xf4\x80\x80\x80",
          "\xf4\x8f\xbf\xbf"}) {
        CAPTURE(character);
        CHECK(json_string(character) == "\"" + character + "\"");
        CHECK(json_string("a" + character + "z") == "\"a" + character + "z\"");
    }
}

TEST_CASE("escape: a text that ends within a character ends there") {
    const std::string_view whole = "a\xc3\xa9";
    CHECK(json_string(whole.substr(0, 2)) == "\"a" + replacement + "\"");
}

TEST_CASE("escape: what moves a terminal's cursor is escaped or replaced, C1 as C0") {
    for (const std::string control : {"\x01", "\x1f", "\x7f", "\xc2\x80", "\xc2\x9f"}) {
        CAPTURE(control);
        CHECK(one_line("a" + control + "z") == "a?z");
        CHECK(json_string(control).starts_with("\"\\u00"));
    }
}

TEST_CASE("escape: what is no character of UTF-8 is replaced, byte by byte") {
    for (const std::string bytes :
         {"\x80", "\xbf", "\xc0\x80", "\xc1\xbf", "\xe0\x80\x80", "\xe0\x9f\xbf", "\xed\xa0\x80",
          "\xed\xbf\xbf", "\xef\xbf\xbe", "\xef\xbf\xbf", "\xf0\x80\x80\x80", "\xf0\x8f\xbf\xbf",
          "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xff", "\xc2", "\xe1\x80", "\xf1\x80\x80"}) {
        CAPTURE(bytes);
        CHECK(json_string(bytes) == "\"" + times(bytes.size(), replacement) + "\"");
    }
    // A character that is cut short by another one does not swallow it.
    CHECK(one_line("\xc2z") == replacement + "z");
    CHECK(one_line("\xe1z\x80") == replacement + "z" + replacement);
    CHECK(one_line("\xe1\x80z") == replacement + replacement + "z");
    CHECK(one_line("\xf1\x80\x80z") == replacement + replacement + replacement + "z");
}

TEST_CASE("escape: control characters and marks") {
    CHECK(one_line("a\nb\tc\x7f\x1f z\x80") == "a?b?c?? z\xef\xbf\xbd");
    CHECK(one_line("\xc2\x9b \xc2\xa0") == "? \xc2\xa0");
    CHECK(json_string("\xc2\x9b \xc2\xa0") == "\"\\u009b \xc2\xa0\"");
    CHECK(json_string("\"\\\n\x1f\x7f /") == "\"\\u0022\\u005c\\u000a\\u001f\\u007f /\"");
    CHECK(json_string("") == "\"\"");
}
