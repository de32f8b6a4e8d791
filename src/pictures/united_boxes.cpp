#include "pictures/united_boxes.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "base/error.hpp"

namespace dumbbell {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polygon = CGAL::Polygon_2<Kernel>;

/// The places on one axis in ascending order. A union of boxes depends on the order of their ends alone, so
/// CGAL gets the places' numbers: integers that are small and quick, whatever the depth of the boxes.
class Places {
  public:
    Places(const std::vector<PlaneBox>& boxes, std::size_t axis) {
        for (const PlaneBox& box : boxes) {
            values_.push_back(box.lo[axis]);
            values_.push_back(box.hi[axis]);
        }
        std::sort(values_.begin(), values_.end());
        values_.erase(std::unique(values_.begin(), values_.end()), values_.end());
    }

    [[nodiscard]] int number(const Rational& value) const {
        return static_cast<int>(std::lower_bound(values_.begin(), values_.end(), value) - values_.begin());
    }
    [[nodiscard]] const Rational& value(const Kernel::FT& number) const {
        return values_.at(static_cast<std::size_t>(CGAL::to_double(number)));  // a whole number: exact
    }

  private:
    std::vector<Rational> values_;
};

Polygon rectangle(const PlaneBox& box, const Places& x, const Places& y) {
    const int left = x.number(box.lo[0]);
    const int right = x.number(box.hi[0]);
    const int bottom = y.number(box.lo[1]);
    const int top = y.number(box.hi[1]);
    Polygon polygon;
    polygon.push_back({left, bottom});
    polygon.push_back({right, bottom});
    polygon.push_back({right, top});
    polygon.push_back({left, top});
    return polygon;
}

/// The vertices at which the curve turns.
Outline outline(const Polygon& polygon, const Places& x, const Places& y) {
    std::vector<PlanePoint> points;
    for (const auto& vertex : polygon.container()) {
        points.push_back({x.value(vertex.x()), y.value(vertex.y())});
    }
    const std::size_t n = points.size();
    Outline turns;
    for (std::size_t i = 0; i < n; ++i) {
        const PlanePoint& before = points[(i + n - 1) % n];
        const PlanePoint& after = points[(i + 1) % n];
        const bool goes_on = (before[0] == points[i][0] && points[i][0] == after[0]) ||
                             (before[1] == points[i][1] && points[i][1] == after[1]);
        if (!goes_on) {
            turns.push_back(points[i]);
        }
    }
    return turns;
}

/// Positive if the curve goes round counterclockwise (outer boundaries), negative for holes.
Rational signed_area(const Outline& outline) {
    Rational twice = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const PlanePoint& a = outline[i];
        const PlanePoint& b = outline[(i + 1) % outline.size()];
        twice += a[0] * b[1] - b[0] * a[1];
    }
    return twice / 2;
}

}  // namespace

std::vector<Outline> united(const std::vector<PlaneBox>& boxes) {
    const Places x(boxes, 0);
    const Places y(boxes, 1);
    std::vector<Polygon> rectangles;
    Rational missing = 0;
    for (const PlaneBox& box : boxes) {
        rectangles.push_back(rectangle(box, x, y));
        missing += (box.hi[0] - box.lo[0]) * (box.hi[1] - box.lo[1]);
    }
    CGAL::Polygon_set_2<Kernel> set;
    set.join(rectangles.begin(), rectangles.end());
    std::vector<CGAL::Polygon_with_holes_2<Kernel>> parts;
    set.polygons_with_holes(std::back_inserter(parts));

    std::vector<Outline> outlines;
    for (const auto& part : parts) {
        outlines.push_back(outline(part.outer_boundary(), x, y));
        for (auto hole = part.holes_begin(); hole != part.holes_end(); ++hole) {
            outlines.push_back(outline(*hole, x, y));
        }
    }
    for (const Outline& curve : outlines) {
        missing -= signed_area(curve);
    }
    require(missing == 0, "the outlines of united boxes do not have their area");
    // CGAL's order depends on addresses nowhere, but is not documented: the picture's order is our own.
    for (Outline& curve : outlines) {
        std::rotate(curve.begin(), std::min_element(curve.begin(), curve.end()), curve.end());
    }
    std::sort(outlines.begin(), outlines.end());
    return outlines;
}

}  // namespace dumbbell
