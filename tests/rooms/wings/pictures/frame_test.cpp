#include "pictures/frame.hpp"

#include <algorithm>
#include <numbers>
#include <set>
#include <utility>

#include "catch.hpp"
#include "xml.hpp"

using namespace dumbbell;
using namespace dumbbell::pictures;
using namespace dumbbell_test;

namespace {

std::vector<std::string> labels(const std::vector<Tick>& ticks) {
    std::vector<std::string> result;
    for (const Tick& tick : ticks) {
        result.push_back(tick.label);
    }
    return result;
}

using Labels = std::vector<std::string>;

constexpr AxisRoom wide{764};

}  // namespace

TEST_CASE("even marks are round numbers from end to end") {
    CHECK(labels(even_ticks(0, 10, 5)) == Labels{"0", "2", "4", "6", "8", "10"});
    CHECK(labels(even_ticks(-0.1, 0.1, 4)) == Labels{"\xe2\x88\x92"
                                                     "0.1",
                                                     "\xe2\x88\x92"
                                                     "0.05",
                                                     "0", "0.05", "0.1"});
    CHECK(labels(even_ticks(0.999, 1.001, 2)) == Labels{"0.999", "1", "1.001"});
}

TEST_CASE("marks of decades, or even ones in less than about a decade") {
    CHECK(labels(decade_ticks(1, 20, wide)) == Labels{"1", "2", "5", "10", "20"});
    CHECK(labels(decade_ticks(6, 9, wide)).size() >= 4);
}

TEST_CASE("numbers along a logarithmic axis keep apart, whatever its range") {
    for (const auto& [lo, hi] : {std::pair{1.0, 1e5},
                                 {1.0, 1e6},
                                 {1.0, 1e8},
                                 {3.0, 3e31},
                                 {1e6, 1.01e6},
                                 {1e6, 9e6},
                                 {4.6, 4.6 + 1e-9},
                                 {1e15, 1e15 + 1e4},
                                 {1e5, 3e6}}) {
        for (const AxisRoom& room : {wide, AxisRoom{250}, AxisRoom{380, true}, AxisRoom{120, true}}) {
            CAPTURE(lo, hi, room.length);
            const PlotAxis axis{lo, hi, "", decade_ticks(lo, hi, room), Scale::logarithmic};
            double end = -1e9;
            int numbers = 0;
            std::set<std::string> different;
            for (const Tick& tick : axis.ticks) {
                if (tick.label.empty()) {
                    continue;
                }
                const double middle = axis.share(tick.value) * room.length;
                const double half = room.upright ? 8 : text_width(tick.label) / 2;
                CHECK(middle - half > end);
                end = middle + half;
                ++numbers;
                different.insert(tick.label);
            }
            CHECK(numbers >= 1);
            CHECK((room.length < wide.length || numbers >= 2));
            CHECK(different.size() == static_cast<std::size_t>(numbers));
        }
    }
}

TEST_CASE("great and small numbers are written with true exponents") {
    CHECK(labels(even_ticks(0, 6e-6, 3)).back() ==
          "6e\xe2\x88\x92"
          "6");
    CHECK(labels(even_ticks(0, 4e12, 2)).back() == "4e12");
}

TEST_CASE("marks of angles are multiples of a quarter turn, at most nine or so") {
    CHECK(labels(angle_ticks(-std::numbers::pi, std::numbers::pi)) ==
          Labels{"\xe2\x88\x92\xcf\x80", "\xe2\x88\x92\xcf\x80/2", "0", "\xcf\x80/2", "\xcf\x80"});
    CHECK(labels(angle_ticks(std::numbers::pi, 2 * std::numbers::pi)) ==
          Labels{"\xcf\x80", "3\xcf\x80/2", "2\xcf\x80"});
    CHECK(angle_ticks(-50, 50).size() <= 10);
    CHECK(labels(angle_ticks(0.2, 0.3)).size() >= 3);
}

TEST_CASE("every scale takes the ends of an axis to its ends, and grows") {
    for (const Scale scale : {Scale::linear, Scale::logarithmic}) {
        const PlotAxis axis{1, 16, "", {}, scale};
        CHECK(axis.share(1) == 0);
        CHECK(axis.share(16) == 1);
        CHECK(axis.share(4) > axis.share(2));
    }
    CHECK(PlotAxis{1, 16, "", {}, Scale::logarithmic}.share(4) == Approx(0.5));
}

TEST_CASE("a frame's vertical axis goes up") {
    const Frame frame(10, 20, 100, 50, {0, 1, "x", {}}, {0, 2, "y", {}});
    CHECK(frame.x(0.5) == 60);
    CHECK(frame.y(0) == 70);
    CHECK(frame.y(2) == 20);
    Svg svg(200, 100, "frame");
    frame.draw_grid(svg);
    frame.draw_axes(svg);
    CHECK(well_formed(svg.finished()));
}

TEST_CASE("a legend that is too wide goes on in the next row") {
    const LegendEntry entry{Swatch::area, "kind", "ten letters"};
    CHECK(Legend({}, 500).height() == 0);
    const double row = Legend({entry}, 500).height();
    CHECK(Legend({entry, entry, entry}, 500).height() == row);
    CHECK(Legend({entry, entry, entry}, 300).height() == 2 * row);
    CHECK(Legend({entry, entry}, 1).height() == 2 * row);
}

TEST_CASE("a caption is broken between words, and none is lost") {
    CHECK(broken_lines("one two three", 1000) == Labels{"one two three"});
    const auto lines = broken_lines("one two three", 60);
    CHECK(lines.size() > 1);
    std::string joined;
    for (const std::string& line : lines) {
        joined += (joined.empty() ? "" : " ") + line;
    }
    CHECK(joined == "one two three");
    CHECK(broken_lines("immeasurable", 1) == Labels{"immeasurable"});
}
