#include "page/data.hpp"

#include "base/error.hpp"
#include "catch.hpp"
#include "rooms/collisions/example.hpp"
#include "rooms/parsed.hpp"
#include "starts/cover/incoming.hpp"

using namespace dumbbell_test;
using namespace dumbbell::collisions;
using namespace dumbbell::page;
using Parsed = nlohmann::ordered_json;

namespace {

Parsed data_of(const Reported& certificate, std::size_t most_boxes = 200'000,
               const std::string& path = "some/file.dbc") {
    return parsed(page_data({{path, "abc123", certificate}}, most_boxes));
}

Parsed file_of(const Reported& certificate) { return data_of(certificate)["files"][0]; }

starts::Node halved(starts::Axis axis) { return {axis, {}}; }
starts::Node closed(long least, std::optional<long> most, std::optional<starts::FirstContact> first = {}) {
    return {std::nullopt, {least, most, std::move(first)}};
}

// phi from 0 to 1, all else fixed; half of it has one collision, a quarter two, a quarter is left open or not
// decided.
starts::Certificate starts_file(starts::Node last) {
    const starts::FirstContact window{true, Rational(1, 2), Rational(3, 4)};
    starts::Certificate certificate{{"dumbbell", "0.1.0"}, {}, 53, {}};
    certificate.box.lo = {0, -1, 3, Rational(-1, 2), 10};
    certificate.box.hi = {1, -1, 3, Rational(-1, 2), 10};
    certificate.tree = {halved(starts::Axis::phi), closed(1, 1, window), halved(starts::Axis::phi),
                        closed(2, 2, window), std::move(last)};
    return certificate;
}

}  // namespace

TEST_CASE("every kind of piece is in the data: equal masses, a gap, an open piece") {
    const Parsed file = file_of(every_kind_of_line());
    CHECK(file["claim"] == "collisions");
    CHECK(file["name"] == "file.dbc");
    CHECK(file["sha256"] == "abc123");
    CHECK(file["scene"] == "dumbbell");
    CHECK(file["section"] == "turning");
    CHECK(file["upper"].is_null());
    REQUIRE(file["pieces"].size() == 3);
    const Parsed& equal = file["pieces"][0];
    CHECK(equal["equal_masses"] == true);
    CHECK(equal["trees"].empty());
    CHECK(equal["status"] == "exact");
    CHECK(equal["paper"] == Parsed{3, 3});
    const Parsed& gap = file["pieces"][1];
    CHECK(gap["status"] == "gap");
    CHECK(gap["bits"] == 128);
    CHECK(gap["lo"] == "1/1");
    CHECK(gap["hi_text"] == "4.5");
    CHECK(gap["paper"] == Parsed{3, 5});
    CHECK(gap["witness"]["e"] == "3/8");
    CHECK(gap["witness"]["eta"] == "1/1024");
    CHECK(file["pieces"][2]["status"] == "open");
    CHECK(file["pieces"][2]["witness"].is_null());
}

TEST_CASE("a tree's leaves are numbered by their kinds, counts last, and its axes are exact") {
    const Parsed file = file_of(every_kind_of_line());
    const Parsed& bridge = file["pieces"][1]["trees"][0];
    CHECK(bridge["chart"] == "bridge");
    CHECK(bridge["leaves"] == 3);
    CHECK(bridge["stands_for"].empty());
    CHECK(bridge["axes"] == Parsed::parse(R"([{"name": "e", "lo": "0/1", "hi": "2/1"},
        {"name": "eta", "lo": "0/1", "hi": "8/1"}, {"name": "q", "lo": "1/1", "hi": "9/2"}])"));
    const Parsed& kinds = file["kinds"];
    const Parsed& nodes = bridge["nodes"];
    CHECK(nodes[0] == -1);
    CHECK(nodes[2] == -2);
    CHECK(kinds[nodes[1].get<std::size_t>()] ==
          Parsed::parse(R"({"reason": "count", "about": "", "forward": 1, "backward": 2,
              "colour": ["#23908c", "#24a485"]})"));
    CHECK(kinds[nodes[3].get<std::size_t>()] ==
          Parsed::parse(R"({"reason": "count", "about": "", "forward": 0, "backward": 3,
              "colour": ["#23908c", "#24a485"]})"));
    CHECK(kinds[nodes[4].get<std::size_t>()]["reason"] == "outside");
    CHECK(kinds[nodes[4].get<std::size_t>()]["colour"] == Parsed{"#e8eaed", "#39424c"});
    CHECK(kinds.back()["reason"] == "count");
    CHECK(file["totals"] == Parsed::parse(R"({"count": 3, "outside": 1, "meets": 1, "meets-reversed": 1})"));
}

TEST_CASE("the verifier is asked for exactly what the file claims") {
    const auto options = [](Certificate certificate) { return file_of(certificate)["verify_options"]; };
    CHECK(options(certificate_of({piece(10, 10, 4, 4)})) == "--ratio 10 --exactly 4");
    CHECK(options(certificate_of({piece(1, 2, 3, 3), piece(2, 3, 5, 4)})) ==
          "--ratio 1:3 --max 5 --min 3 --gap 0.5 --gaps 1");
    CHECK(options(certificate_of({open_piece(5, 12)})) == "--ratio 5:12");
}

TEST_CASE("the paper's bound is one of the dumbbell, and of ratios that it can be computed for") {
    Certificate body = certificate_of({piece(1, 2, 3, 2)});
    body.system = {Section::body, 1};
    body.pieces[0].cover = {};
    CHECK(file_of(body)["pieces"][0]["paper"].is_null());
    CHECK(file_of(certificate_of({piece(2, exact(1e40), 4, 3)}))["pieces"][0]["paper"].is_null());
}

TEST_CASE("file names are quoted as a shell needs it") {
    const auto quoted = [](const std::string& path) {
        return data_of(certificate_of({piece(10, 10, 4, 4)}), 10, path)["files"][0]["verify_file"];
    };
    CHECK(quoted("a/b-1.dbc.gz") == "b-1.dbc.gz");
    CHECK(quoted("two words.dbc") == "'two words.dbc'");
    CHECK(quoted("it's.dbc") == "'it'\\''s.dbc'");
    CHECK(quoted("$(x).dbc") == "'$(x).dbc'");
    CHECK(quoted("-x.dbc") == "./-x.dbc");
}

TEST_CASE("more boxes than a page takes are thinned out, tree by tree, and the page is told") {
    const Parsed data = data_of(every_kind_of_line(), 2);
    CHECK(data["boxes"]["total"] == 6);
    CHECK(data["boxes"]["most"] == 2);
    for (const Parsed& tree : data["files"][0]["pieces"][1]["trees"]) {
        CHECK(tree["leaves"] == 3);
        CHECK(tree["nodes"].size() == 1);
        CHECK(tree["stands_for"] == Parsed{3});
    }
}

TEST_CASE("more pieces than a page takes are refused with advice") {
    std::vector<Piece> pieces(most_pieces + 1, open_piece(2, 2));
    CHECK_THROWS_WITH(data_of(certificate_of(std::move(pieces))), Contains("fewer files"));
}

TEST_CASE("initial conditions: kinds with their first mass, exact shares, bounds over the box") {
    const Parsed file = file_of(starts_file(closed(1, 3)));
    CHECK(file["claim"] == "initial-conditions");
    CHECK(file["least"] == 1);
    CHECK(file["most"] == 3);
    CHECK(file["verify_options"] ==
          "--claim initial-conditions --phi 0:1 --phidot -1 --y 3 --ydot -0.5 --ratio 10 --max 3 --min 1 "
          "--decided 0.75");
    CHECK(file["tree"]["axes"][0] == Parsed::parse(R"({"name": "phi", "lo": "0/1", "hi": "1/1"})"));
    CHECK(file["tree"]["axes"][3]["lo"] == "-1/2");
    CHECK(file["tree"]["nodes"] == Parsed{-1, 0, -1, 1, 2});
    CHECK(file["kinds"][0] == Parsed::parse(R"({"least": 1, "most": 1, "first": "heavy",
        "colour": ["#fde725", "#fde725"]})"));
    CHECK(file["kinds"][2] == Parsed::parse(R"({"least": 1, "most": 3, "first": null, "colour": null})"));
    CHECK(file["windows"] == Parsed{0.5, 0.75, 0.5, 0.75, nullptr, nullptr});
    CHECK(file["shares"] == Parsed::parse(R"([{"collisions": null, "share": "0.25", "boxes": 1},
        {"collisions": 1, "share": "0.5", "boxes": 1}, {"collisions": 2, "share": "0.25", "boxes": 1}])"));
}

TEST_CASE("incoming trajectories: the two coordinates of their section, and the mass ratio") {
    starts::Certificate certificate = starts_file(closed(1, 3));
    certificate.incoming = true;
    certificate.box = starts::incoming_box(10);
    const Parsed file = file_of(certificate);
    CHECK(file["claim"] == "incoming");
    CHECK(file["ratio"] == "10/1");
    CHECK(file["verify_options"] == "--claim incoming --ratio 10 --max 3 --min 1 --decided 0.75");
    CHECK(file["tree"]["axes"] == Parsed::parse(R"([{"name": "phi_over_pi", "lo": "0/1", "hi": "2/1"},
        {"name": "s", "lo": "0/1", "hi": "1/1"}])"));
    CHECK(file["shares"][1]["share"] == "0.5");
}

TEST_CASE("an open part leaves no upper bound, and no lower one but 0") {
    const Parsed file = file_of(starts_file(closed(0, std::nullopt)));
    CHECK(file["least"] == 0);
    CHECK(file["most"].is_null());
    CHECK(file["verify_options"] ==
          "--claim initial-conditions --phi 0:1 --phidot -1 --y 3 --ydot -0.5 --ratio 10 --decided 0.75");
}

TEST_CASE("a tree of initial conditions deeper than the format permits is refused, not computed with") {
    starts::Certificate certificate = starts_file(closed(1, 1));
    certificate.tree.assign(100'000, halved(starts::Axis::phi));
    certificate.tree.insert(certificate.tree.end(), 100'001, closed(1, 1));
    CHECK_THROWS_WITH(file_of(certificate), Contains("levels deep"));
}

TEST_CASE("the constant C has 20 digits that are proved") {
    CHECK(data_of(certificate_of({piece(10, 10, 4, 4)}))["growth_constant"] == "0.88559512945271391141");
}
