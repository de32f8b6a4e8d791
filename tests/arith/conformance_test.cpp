// The public IEEE 1788 vectors, if they lie beside the repository: they are data under other licences and
// stay out of it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "arith/elementary.hpp"
#include "arith/interval.hpp"
#include "tightest.hpp"

using namespace dumbbell;
using namespace dumbbell_test;

namespace {

using Arguments = std::vector<Interval>;

const std::map<std::string, std::function<Interval(const Arguments&)>>& operations() {
    static const std::map<std::string, std::function<Interval(const Arguments&)>> table = {
        {"add", [](const Arguments& x) { return x.at(0) + x.at(1); }},
        {"sub", [](const Arguments& x) { return x.at(0) - x.at(1); }},
        {"mul", [](const Arguments& x) { return x.at(0) * x.at(1); }},
        {"div", [](const Arguments& x) { return x.at(0) / x.at(1); }},
        {"recip", [](const Arguments& x) { return Interval(1) / x.at(0); }},
        {"neg", [](const Arguments& x) { return -x.at(0); }},
        {"sqr", [](const Arguments& x) { return sqr(x.at(0)); }},
        {"sqrt", [](const Arguments& x) { return sqrt(x.at(0)); }},
        {"abs", [](const Arguments& x) { return abs(x.at(0)); }},
        {"min", [](const Arguments& x) { return min(x.at(0), x.at(1)); }},
        {"max", [](const Arguments& x) { return max(x.at(0), x.at(1)); }},
        {"convexHull", [](const Arguments& x) { return hull(x.at(0), x.at(1)); }},
        {"sin", [](const Arguments& x) { return sin(x.at(0)); }},
        {"cos", [](const Arguments& x) { return cos(x.at(0)); }},
        {"asin", [](const Arguments& x) { return asin(x.at(0)); }}};
    return table;
}

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);) {
        parts.push_back(part);
    }
    return parts;
}

/// Nothing for the empty interval and for what is none.
std::optional<Interval> parse(const std::string& text) {
    if (text == "entire") {
        return Interval(-HUGE_VAL, HUGE_VAL);
    }
    const auto ends = split(text, ',');
    if (ends.size() != 2) {
        return std::nullopt;
    }
    return Interval(std::strtod(ends[0].c_str(), nullptr), std::strtod(ends[1].c_str(), nullptr));
}

/// Excess beyond this counts as loose: division by intervals with an end in 0 (Interval gives more than the
/// half line), sine and cosine near their zeros and far out, asin near +-1.
constexpr std::int64_t loose = 16;

struct Tally {
    int tested = 0;
    int skipped = 0;
    int loosely = 0;
    std::int64_t excess = 0;  // the greatest that is not loose

    void add(std::int64_t ulps) {
        if (ulps > loose) {
            ++loosely;
        } else {
            excess = std::max(excess, ulps);
        }
    }
};

/// What the operation promises, in doubles; nothing where some results may be loose.
std::optional<std::int64_t> promised_excess(const std::string& operation) {
    if (operation == "div" || operation == "sin" || operation == "cos" || operation == "asin") {
        return std::nullopt;
    }
    const bool exact = operation == "neg" || operation == "abs" || operation == "min" || operation == "max" ||
                       operation == "convexHull";
    return exact ? 0 : 1;
}

}  // namespace

TEST_CASE("Every result of the IEEE 1788 vectors is enclosed") {
    std::ifstream table(DUMBBELL_CONFORMANCE);
    if (!table) {
        WARN("skipped: no vectors at " << DUMBBELL_CONFORMANCE);
        return;
    }
    std::map<std::string, Tally> tallies;
    for (std::string line; std::getline(table, line);) {
        const auto fields = split(line, '\t');
        const auto operation = fields.size() < 3 ? operations().end() : operations().find(fields[0]);
        if (operation == operations().end()) {
            continue;
        }
        Tally& tally = tallies[fields[0]];
        Arguments arguments;
        bool empty = false;
        for (const auto& argument : split(fields[1], ';')) {
            const auto x = parse(argument);
            empty = empty || !x;
            arguments.push_back(x.value_or(Interval(0)));
        }
        const auto expected = parse(fields[2]);
        if (empty || !expected) {  // empty in or out: outside the domain that Interval documents
            ++tally.skipped;
            continue;
        }
        ++tally.tested;
        const Interval ours = operation->second(arguments);
        const Tightest exact{expected->lo(), expected->hi()};
        if (!encloses(ours, exact)) {
            FAIL_CHECK(line << " gives " << show(ours));
        } else {
            tally.add(excess(ours, exact));
        }
    }
    std::string report;
    for (const auto& [name, tally] : tallies) {
        report += fmt::format("{}: tested {}, skipped {}, greatest excess {}, looser than {} ulps: {}\n",
                              name, tally.tested, tally.skipped, tally.excess, loose, tally.loosely);
        CAPTURE(name);
        CHECK(tally.tested > 0);
        const auto promised = promised_excess(name);
        CHECK((!promised || (tally.loosely == 0 && tally.excess <= *promised)));
    }
    WARN(report);
    CHECK(tallies.size() == operations().size());
}
