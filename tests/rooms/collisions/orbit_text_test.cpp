#include "collisions/orbit_text.hpp"

#include <sstream>

#include "catch.hpp"
#include "rooms/parsed.hpp"
#include "sample_report.hpp"

using namespace dumbbell_test;

namespace {

const Interval time_of_second(4.407749353840012, 4.4077493538400395);
const Interval phi_of_second(3.1676916779706, 3.1676916779707);

struct ReportWithOrbit : SampleReport {
    ReportWithOrbit() : SampleReport({piece(10, 10, 4, 2)}) {
        report.rows[0].orbit = {collision(false, Interval(0), Interval(-0.7375, -0.7374)),
                                collision(true, time_of_second, phi_of_second)};
    }
};

struct Enclosed {
    Rational centre;
    Rational radius;
    [[nodiscard]] bool holds(const Interval& x) const {
        return centre - radius <= exact(x.lo()) && exact(x.hi()) <= centre + radius;
    }
};

// "1.5+-1.0e-14", exactly as printed.
Enclosed parse(const std::string& text) {
    const std::size_t sign = text.find("+-");
    REQUIRE(sign != std::string::npos);
    const std::string centre = text.substr(0, sign);
    const Rational value = parse_rational(centre.starts_with('-') ? centre.substr(1) : centre);
    return {centre.starts_with('-') ? -value : value, parse_rational(text.substr(sign + 2))};
}

std::vector<std::string> fields_of_line(const std::string& text, const std::string& start) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::vector<std::string> fields{std::istream_iterator<std::string>(words), {}};
        if (!fields.empty() && fields[0] == start) {
            return fields;
        }
    }
    return {};
}

}  // namespace

TEST_CASE("an orbit has a line per collision with mass, time, angle, height and velocities") {
    const ReportWithOrbit sample;
    const std::string text = orbits_to_text(sample.report);
    CHECK_THAT(text, Contains("Witness at mass ratio 10: 2 collisions"));
    const auto first = fields_of_line(text, "1");
    const auto second = fields_of_line(text, "2");
    REQUIRE(first.size() == 9);
    REQUIRE(second.size() == 9);
    CHECK(first[1] == "light");
    CHECK(second[1] == "heavy");
    CHECK_THAT(text, Contains("Smallest margin") && Contains("0.125 rad"));
}

TEST_CASE("a printed value and its radius, read as they are printed, enclose the number") {
    const ReportWithOrbit sample;
    const std::string text = orbits_to_text(sample.report);
    const auto first = fields_of_line(text, "1");
    const auto second = fields_of_line(text, "2");
    REQUIRE(second.size() == 9);
    CAPTURE(text);
    CHECK(parse(first[2]).holds(Interval(0)));
    CHECK(parse(first[3]).holds(Interval(-0.7375, -0.7374)));
    CHECK(parse(second[2]).holds(time_of_second));
    CHECK(parse(second[3]).holds(phi_of_second));
    CHECK(parse(second[4]).holds(Interval(0.25)));
    CHECK(parse(second[8]).holds(Interval(-0.75)));
}

TEST_CASE("rows without an orbit print nothing") {
    const SampleReport sample(three_pieces());
    CHECK(orbits_to_text(sample.report).empty());
}

TEST_CASE("in JSON the orbit's enclosures are pairs of doubles, exactly the computed ones") {
    const ReportWithOrbit sample;
    const auto witness = parsed(to_json(sample.report)).at("pieces").at(0).at("witness");
    CHECK(witness.at("ratio") == "10/1");
    REQUIRE(witness.at("collisions").size() == 2);
    const auto second = witness.at("collisions").at(1);
    CHECK(second.at("mass") == "heavy");
    CHECK(second.at("time").at(0) == time_of_second.lo());
    CHECK(second.at("time").at(1) == time_of_second.hi());
    for (const char* field :
         {"phi", "y", "ydot_before", "ydot_after", "phidot_before", "phidot_after", "grazing_sine"}) {
        CAPTURE(field);
        REQUIRE(second.at(field).size() == 2);
        CHECK(second.at(field).at(0) <= second.at(field).at(1));
    }
}

TEST_CASE("the widths are listed at collisions 1, 10, 100 and the last, with the widest") {
    std::vector<dumbbell::flight::Collision<Interval>> orbit(25,
                                                             collision(false, Interval(0), Interval(1, 1.5)));
    orbit[0].y = Interval(0, 0.24999);
    orbit[3].phi = Interval(0, 4);
    const std::string text = dumbbell::collisions::widths_text(orbit);
    CAPTURE(text);
    for (const char* number : {"1", "10", "25"}) {
        const auto fields = fields_of_line(text, number);
        REQUIRE(fields.size() == 5);
        CHECK(std::stod(fields[1]) == Approx(0.5).epsilon(0.01));
        CHECK(fields[2] == (std::string(number) == "1" ? "0.25" : "0"));
    }
    CHECK(fields_of_line(text, "4").empty());
    const auto widest = fields_of_line(text, "widest");
    REQUIRE(widest.size() == 5);
    CHECK(std::stod(widest[1]) == Approx(4).epsilon(0.01));
}
