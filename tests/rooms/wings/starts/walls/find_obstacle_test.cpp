// Starts that are put a hair beside a corner, a flat fall or a grazing contact: they have their names.
#include "starts/walls/find_obstacle.hpp"

#include <cmath>

#include "catch.hpp"
#include "rooms/wings/starts/box.hpp"
#include "starts/answer/trace.hpp"
#include "starts/cover/subdivide.hpp"

using namespace dumbbell;
using namespace dumbbell::starts;
using dumbbell_trace_test::point;

namespace {

std::optional<Obstacle> obstacle_of(const Box& box, int digits = 0) {
    const Trace traced = trace(box, digits);
    CHECK(traced.obstacle.has_value() != traced.exact());
    return traced.obstacle;
}

/// At the angle of a grazing contact of the light mass the start's y, so that it happens at the time 1.
Box grazing(double phidot, double ydot, double q, double off) {
    const double beta2 = q / (1 + q);
    const double angle = -std::acos(-ydot / (beta2 * phidot));
    return point(exact(angle - phidot), exact(phidot), exact(-ydot - beta2 * std::sin(angle) + off),
                 exact(ydot), exact(q));
}

}  // namespace

TEST_CASE("next to a flat fall or a corner an undecided start is said to be so, at any precision") {
    const Rational hair = Rational(1) / exact(0x1p100);
    const Rational thinner = Rational(1) / exact(0x1p900);  // than 40 digits tell
    for (const int sign : {-1, 1}) {
        CHECK(obstacle_of(point(hair * sign, 0, 3, -1, 10)) == Obstacle::flat);
        CHECK(obstacle_of(point(thinner * sign, 0, 3, -1, 10), 40) == Obstacle::flat);
        CHECK(obstacle_of(point(Rational(-1) + hair * sign, 1, 1, -1, 10)) == Obstacle::corner);
        CHECK(obstacle_of(point(Rational(-1) + thinner * sign, 1, 1, -1, 10), 40) == Obstacle::corner);
        CHECK_FALSE(obstacle_of(point(Rational(sign, 1000), 0, 3, -1, 10)));
    }
}

TEST_CASE("next to a grazing contact an undecided start is said to be so") {
    for (const double q : {1.0, 4.0, 100.0}) {
        for (const double phidot : {1.5, -2.5}) {
            for (const double ydot : {-0.3, 0.2}) {
                const double sign = phidot > 0 ? 1 : -1;
                CAPTURE(q, phidot, ydot);
                const Box box = grazing(sign * phidot, ydot, q, 0);
                const auto found = obstacle_of(box);
                CHECK((!found || *found == Obstacle::graze));
                CHECK_FALSE(obstacle_of(grazing(sign * phidot, ydot, q, 1e-3)) == Obstacle::corner);
            }
        }
    }
    CHECK(obstacle_of(grazing(1.5, -0.3, 4, 0)) == Obstacle::graze);
    CHECK(obstacle_of(grazing(1.5, 0.2, 4, 0)) == Obstacle::graze);
}

TEST_CASE("a contact after the first collision that only just happens, or does not, is named") {
    const auto at = [](const Rational& y) { return point(Rational(-1, 2), Rational(1, 2), y, -1, 10); };
    Rational two(3, 2), one(17, 10);  // the heights from which there are two collisions, and one
    for (int i = 0; i < 110; ++i) {
        const Rational middle = (two + one) / 2;
        const Trace traced = trace(at(middle), 60);
        REQUIRE(traced.exact());
        (traced.least == 2 ? two : one) = middle;
    }
    CHECK(obstacle_of(at(two)) == Obstacle::graze);
    CHECK(trace(at(two), 0).collisions.size() == 1);
}

TEST_CASE("starts whose centre keeps the height of the light mass's half only graze, and never collide") {
    for (const int q : {1, 2, 10, 1000}) {
        const Rational beta2(q, 1 + q);
        const Trace traced = trace(point(0, Rational(7, 3), beta2, 0, q), 0);
        CHECK(traced.exact());
        CHECK(traced.least == 0);
        CHECK_FALSE(trace(point(0, Rational(7, 3), beta2 - Rational(1, 1000), 0, q), 0).least == 0);
    }
}

TEST_CASE("every undecided box of a subdivision is counted by what it is near to, most of them by name") {
    Box box;
    box.lo = {0, Rational(1, 2), Rational(3, 2), -1, 10};
    box.hi = {3, Rational(1, 2), Rational(3, 2), -1, 10};
    const Subdivision one = subdivide(box, {.max_boxes = 500, .jobs = 1});
    const Subdivision two = subdivide(box, {.max_boxes = 500, .jobs = 2});
    CHECK(one.near == two.near);
    long sum = 0;
    for (const long boxes : one.near) {
        sum += boxes;
    }
    CHECK(sum == one.undecided.boxes);
    CHECK(one.unexplained == 0);
    CHECK(one.near.at(static_cast<std::size_t>(Obstacle::other)) * 20 <= sum);
    const Subdivision stopped = subdivide(box, {.max_boxes = 500, .interrupted = [] { return true; }});
    CHECK(stopped.unexplained == stopped.undecided.boxes);
}
