
#include "catch.hpp"
#include "page/data.hpp"
#include "rooms/parsed.hpp"

using namespace dumbbell;
using namespace dumbbell::page;
using dumbbell_test::parsed;

namespace {

// What the page reads: the text of the script element with the data.
std::string data_in(const std::string& page) {
    const std::string start = "<script type=\"application/json\" id=\"data\">";
    const std::size_t at = page.find(start);
    REQUIRE(at != std::string::npos);
    const std::size_t begin = at + start.size();
    return page.substr(begin, page.find("</script>", begin) - begin);
}

}  // namespace

TEST_CASE("the page is one HTML file that may load nothing") {
    const std::string page = html_page(Json::object({{"files", Json::array()}}));
    CHECK_THAT(page, StartsWith("<!doctype html>") && Contains("default-src 'none'") && Contains("</html>"));
    for (const char* reference : {"src=", "@import", "url(", "http://", "<link rel=\"stylesheet\""}) {
        CAPTURE(reference);
        CHECK_THAT(page, !Contains(reference));
    }
}

TEST_CASE("the data arrives as it was, whatever it holds") {
    const Json data = Json::object(
        {{"name", "</script><script>alert(1)</script><!-- & \" \\ \n \xe2\x80\xa8"}, {"number", 0.1}});
    const std::string page = html_page(data);
    CHECK(nlohmann::ordered_json::parse(data_in(page)) == parsed(data));
    CHECK_THAT(data_in(page), !Contains("<"));
    CHECK_THAT(page, !Contains("@DUMBBELL_DATA@"));
}

TEST_CASE("bytes that are no UTF-8 do not stop the page") {
    CHECK_NOTHROW(html_page(Json::object({{"name", "\xff\xfe.dbc"}})));
}
