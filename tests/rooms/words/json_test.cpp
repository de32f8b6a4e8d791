#include "words/json.hpp"

#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "catch.hpp"

using namespace dumbbell;
using Reference = nlohmann::ordered_json;

namespace {

/// An object with a value of every kind, and the same in nlohmann's words.
Json sample() {
    return Json::object({{"text", "a \"b\" \\ \n \x01 </script> \xc3\xa9 \xe2\x80\xa8"},
                         {"empty", ""},
                         {"numbers", Json::array({-1, 0.1, 1e-9, 1e300, 3.0, -0.0})},
                         {"count", Count(7)},
                         {"yes", true},
                         {"nothing", nullptr},
                         {"no fields", Json::object()},
                         {"no values", Json::array()},
                         {"objects", Json::array({Json::object({{"n", 1}}), Json::object({{"n", 2}})})}});
}

Reference reference() {
    return {{"text", "a \"b\" \\ \n \x01 </script> \xc3\xa9 \xe2\x80\xa8"},
            {"empty", ""},
            {"numbers", {-1, 0.1, 1e-9, 1e300, 3.0, -0.0}},
            {"count", 7},
            {"yes", true},
            {"nothing", nullptr},
            {"no fields", Reference::object()},
            {"no values", Reference::array()},
            {"objects", {{{"n", 1}}, {{"n", 2}}}}};
}

}  // namespace

TEST_CASE("JSON is spelled as nlohmann's library spells it, on one line and indented, in ASCII") {
    CHECK(sample().text() == reference().dump(-1, ' ', true));
    CHECK(json_text(sample()) == reference().dump(2, ' ', true) + '\n');
}

TEST_CASE("an integer is a number below 2^53, which doubles hold, and a string from there on") {
    constexpr long last = (1L << 53) - 1;
    CHECK(Json(last).text() == "9007199254740991");
    CHECK(Json(last + 1).text() == R"("9007199254740992")");
    CHECK(Json(-last).text() == "-9007199254740991");
    CHECK(Json(-last - 1).text() == R"("-9007199254740992")");
    CHECK(Json(std::numeric_limits<long>::min()).text() == R"("-9223372036854775808")");
    CHECK(Json(static_cast<unsigned long>(last)).text() == "9007199254740991");
    CHECK(Json(std::numeric_limits<std::uint64_t>::max()).text() == R"("18446744073709551615")");
    CHECK(Json(Count(last)).text() == "9007199254740991");
    CHECK(Json(Count(last) + 1).text() == R"("9007199254740992")");
    CHECK(Json(Count(std::numeric_limits<long>::max()) + 1).text() == R"("9223372036854775808")");
}

TEST_CASE("fields and values that are added come last") {
    Json list = Json::array(std::vector<std::string>{"["});
    list.add(Json::array());
    list.add(2);
    Json json = Json::object();
    json.add("list", list);
    json.add("last", "{");
    CHECK(json.text() == R"({"list":["[",[],2],"last":"{"})");
}

TEST_CASE("bytes that are no UTF-8 are replaced, and a number that is not finite is null") {
    CHECK(Json("\xff\xfe.dbc").text() == R"("\ufffd\ufffd.dbc")");
    CHECK(Json(std::numeric_limits<double>::infinity()).text() == "null");
}

TEST_CASE("what is not known is null") {
    CHECK(Json(std::optional<long>(3)).text() == "3");
    CHECK(Json(std::optional<std::string>("x")).text() == "\"x\"");
    CHECK(Json(std::optional<long>()).text() == "null");
}

TEST_CASE("the ends of an enclosure have no zero with a sign") {
    CHECK(ends_json(Interval(-0.0, 0.5)).text() == "[0.0,0.5]");
    CHECK(ends_json(Interval(-0.5, -0.0)).text() == "[-0.5,0.0]");
}
