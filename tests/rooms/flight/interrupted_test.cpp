// A count that is interrupted says less than it could, never more.
#include "base/interrupted.hpp"

#include "catch.hpp"
#include "flight/count.hpp"
#include "flight/departure.hpp"
#include "flight/extremal_orbit.hpp"
#include "flight/plain.hpp"

using namespace dumbbell;
using namespace dumbbell::flight;

namespace {

// Interrupted the n-th time it is asked.
class Patience {
  public:
    explicit Patience(int n) : left_(n) {}
    bool operator()() { return left_-- <= 0; }

  private:
    int left_;
};

constexpr long interrupted_cap = 15'000;  // no macro step, which is a question of its own

}  // namespace

TEST_CASE("An interrupted upper count is undecided, an interrupted lower count is what was seen") {
    const Ray<Interval> ray = extremal_ray(ExtremalOrbit::corner, Interval(1e-8));
    const long all = count_at_least(ray, interrupted_cap);
    REQUIRE(all > 3 * flights_between_questions);
    CHECK(count_at_most(ray, interrupted_cap) == all);
    for (int n = 0; n < 3; ++n) {
        CHECK(count_at_most(ray, interrupted_cap, Patience(n)) == interrupted_cap + 1);
        CHECK(count_at_least(ray, interrupted_cap, Patience(n)) == (n + 1) * flights_between_questions);
    }
    CHECK(count_at_most(ray, interrupted_cap, Patience(1000)) == all);
    CHECK(count_at_least(ray, interrupted_cap, Patience(1000)) == all);
}

TEST_CASE("A count in multiple precision asks before each flight whether to end") {
    const PrecisionScope scope(200);
    const Ray<BigInterval> ray = extremal_ray(ExtremalOrbit::corner, BigInterval(1e-8));
    const Count cap = 1000;  // no macro step
    for (const int n : {0, 1, 100}) {
        CHECK(count_at_most(ray, cap, Patience(n)) == cap + 1);
        CHECK(count_at_least(ray, cap, Patience(n)) == n + 1);
    }
}

TEST_CASE("Interrupted counts of departures and of plain boxes are undecided") {
    const Interval r(1e-8);
    const RatioRange<Interval> range{r, r};
    const Departure<Interval> steep = departure(position(Interval(1e-3)), Interval(1) + Interval(1e-7));
    REQUIRE(later_collisions_at_most(steep, steep, range, interrupted_cap) < interrupted_cap);
    CHECK(later_collisions_at_most(steep, steep, range, interrupted_cap, Patience(0)) == interrupted_cap + 1);
    const flight::PlainRay<Interval> thin{Interval(0), Interval(1e-7)};
    CHECK(plain_count(thin, flight::Body<Interval>::massless(r), interrupted_cap, Patience(0)) ==
          interrupted_cap + 1);
    const PlainDeparture<Interval> from{steep.x, steep.sin_x, steep.kappa};
    CHECK(plain_later_collisions(from, flight::Body<Interval>::massless(r), interrupted_cap, Patience(0)) ==
          interrupted_cap + 1);
}
