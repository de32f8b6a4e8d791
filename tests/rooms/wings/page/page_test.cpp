#include "catch.hpp"
#include "collisions/chart.hpp"
#include "collisions/section.hpp"
#include "page/data.hpp"
#include "rooms/parsed.hpp"
#include "rooms/wings/pictures/xml.hpp"
#include "temporary_folder.hpp"

using namespace dumbbell;
using namespace dumbbell::page;
using dumbbell_test::contents;
using dumbbell_test::count_of;
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

// Whether a table in the page's source has an entry for a word.
void check_known(const std::string& source, std::string_view word) {
    const std::string entry = "\n    " + std::string(word);
    CHECK_THAT(source, Contains(entry + ":") || Contains(entry + ","));
}

}  // namespace

TEST_CASE("the page is one HTML file that may load nothing") {
    const std::string page = html_page(Json::object({{"files", Json::array()}}));
    CHECK_THAT(page, StartsWith("<!doctype html>") && Contains("default-src 'none'") && Contains("</html>"));
    for (const char* reference : {"src=", "@import", "http://", "<link rel=\"stylesheet\""}) {
        CAPTURE(reference);
        CHECK_THAT(page, !Contains(reference));
    }
    CHECK(count_of(page, "url(") == count_of(page, "url(#"));  // within a picture that is saved
}

TEST_CASE("the data arrives as it was, whatever it holds") {
    const Json data = Json::object(
        {{"name", "</script><script>alert(1)</script><!-- & \" \\ \n \xe2\x80\xa8"}, {"number", 0.1}});
    const std::string page = html_page(data);
    CHECK(nlohmann::ordered_json::parse(data_in(page)) == parsed(data));
    CHECK_THAT(data_in(page), !Contains("<"));
    CHECK_THAT(page, !Contains("@DUMBBELL_DATA@"));
}

TEST_CASE("base64 is that of RFC 4648") {
    CHECK(base64("").empty());
    CHECK(base64("f") == "Zg==");
    CHECK(base64("fo") == "Zm8=");
    CHECK(base64("foo") == "Zm9v");
    CHECK(base64("foob") == "Zm9vYg==");
    CHECK(base64("\xff\xfb\xf0") == "//vw");
}

TEST_CASE("the verifier has a place of its own, which no data takes") {
    const Json data = Json::object({{"name", "@DUMBBELL_VERIFIER@"}});
    CHECK_THAT(html_page(data), Contains("id=\"verifier\"></script>") && Contains("@DUMBBELL_VERIFIER@"));
    CHECK_THAT(html_page(data, "foob"), Contains("id=\"verifier\">Zm9vYg==</script>"));
}

TEST_CASE("bytes that are no UTF-8 do not stop the page") {
    CHECK_NOTHROW(html_page(Json::object({{"name", "\xff\xfe.dbc"}})));
}

TEST_CASE("the page can draw every chart, and knows the lemmas of every scene and section") {
    const std::string lemmas = contents(DUMBBELL_PROJECT "/web/src/lemmas.js");
    const std::string charts = contents(DUMBBELL_PROJECT "/web/src/charts.js");
    for (int i = 0; i <= static_cast<int>(collisions::Section::plain_body); ++i) {
        const collisions::SectionRow& row = row_of(static_cast<collisions::Section>(i));
        check_known(lemmas, row.scene == "dumbbell" ? row.section : row.scene);
        for (const collisions::Chart chart : row.charts) {
            check_known(charts, row_of(chart).name);
        }
    }
}
