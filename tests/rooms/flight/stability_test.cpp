// Enclosures along orbits that are hard to enclose, in five forms: each contains the orbits of all its
// points, and how far they get.
#include "catch.hpp"
#include "hard_orbits.hpp"
#include "reference.hpp"
#include "rooms/number/random.hpp"
#include "rooms/number/show.hpp"

using namespace dumbbell;
using namespace dumbbell_test;

namespace {

/// The departures after each collision from which an orbit turns back, and the number of its collisions.
template <class T>
struct Exact {
    std::vector<dumbbell_test::WallState<T>> departures;
    std::size_t collisions = 0;
};

template <class T>
Exact<T> exact_orbit(dumbbell_test::WallState<T> from, const T& r) {
    Exact<T> orbit;
    while (from.kappa < 1) {
        const auto to_wall = exact_flight<T>(T(sin(from.x) + from.kappa * (from.x + pi_in<T>())), from.kappa);
        if (!to_wall.hits) {
            break;
        }
        ++orbit.collisions;
        const auto out = reflect<T>({T(1), from.kappa}, T(cos(to_wall.x)), r);
        if (out.angular >= 0) {
            break;
        }
        from = {to_wall.x, out.vertical / -out.angular};
        orbit.departures.push_back(from);
    }
    return orbit;
}

template <class T, class I>
T inside(const I& x, double share) {
    const T low = low_of<T>(x);
    return low + (high_of<T>(x) - low) * share;
}

/// Fails if the orbit of a point of `start` leaves an enclosure, or if its number of collisions contradicts
/// them.
template <class T, class I>
void check_contains(const HardOrbit& orbit, Form form, const dumbbell_test::WallState<I>& start,
                    double share_x, double share_kappa) {
    const I r(orbit.r);
    const auto ours = propagate(form, start, r);
    const auto exact =
        exact_orbit<T>({inside<T>(start.x, share_x), inside<T>(start.kappa, share_kappa)}, T(orbit.r));
    const std::string where = say(orbit.name, name_of(form), "shares", share_x, share_kappa);
    if (ours.boxes.size() > exact.departures.size() || ours.collisions() > exact.collisions ||
        (ours.finished() && ours.collisions() != exact.collisions)) {
        FAIL(say(where, "has", exact.collisions, "collisions, certified", ours.collisions()));
    }
    for (std::size_t i = 0; i < ours.boxes.size(); ++i) {
        if (!encloses(ours.boxes[i].x, exact.departures[i].x) ||
            !encloses(ours.boxes[i].kappa, exact.departures[i].kappa)) {
            FAIL(say(where, "leaves the enclosure after collision", i + 1, exact.departures[i].x,
                     exact.departures[i].kappa, "of", ours.boxes[i].x, ours.boxes[i].kappa));
        }
    }
}

template <class T, class I>
void check_all_contain(std::uint64_t seed, int bits, int points) {
    Random random(seed);
    for (const HardOrbit& orbit : hard_orbits()) {
        const PrecisionScope scope(bits);
        for (const Form form : all_forms) {
            check_contains<T>(orbit, form, point<I>(orbit), 0, 0);
            for (int k = 0; k < points; ++k) {
                const auto share = [&] { return random.coin() ? random.uniform(0, 1) : random.below(2); };
                check_contains<T>(orbit, form, small_box<I>(orbit, bits), share(), share());
            }
        }
    }
}

std::size_t certified(const HardOrbit& orbit, Form form) {
    return propagate(form, point<Interval>(orbit), Interval(orbit.r)).collisions();
}

HardOrbit named(const std::string& name) {
    for (const HardOrbit& orbit : hard_orbits()) {
        if (orbit.name == name) {
            return orbit;
        }
    }
    throw std::logic_error("no such orbit");
}

}  // namespace

TEST_CASE("In doubles every form contains the orbits of the points of its box") {
    check_all_contain<Real, Interval>(231, 53, 2);
}

TEST_CASE("With 64 bits every form contains the orbits of the points of its box") {
    check_all_contain<Real, BigInterval>(232, 64, 1);
}

TEST_CASE("The lowest and the highest ray survive every orbit whole in doubles, a point and a box") {
    for (const HardOrbit& orbit : hard_orbits()) {
        CAPTURE(orbit.name);
        const std::size_t all = length(orbit);
        for (const auto& start : {point<Interval>(orbit), small_box<Interval>(orbit, 53)}) {
            const auto followed = propagate(Form::monotone, start, Interval(orbit.r));
            CHECK(followed.finished());
            CHECK(followed.collisions() == all);
        }
    }
    CHECK(length(named("q = 1e6")) > 400);
    CHECK(length(named("long descent")) > 800);
}

TEST_CASE("Steps in mean value form survive hundreds of bounces in doubles, natural ones do not") {
    for (const char* name : {"q = 1e6", "long descent"}) {
        CAPTURE(name);
        const HardOrbit orbit = named(name);
        const std::size_t all = length(orbit);
        CHECK(certified(orbit, Form::mean_value) == all);
        CHECK(certified(orbit, Form::parallelepiped) == all);
        CHECK(certified(orbit, Form::natural) < 50);
        CHECK(certified(orbit, Form::natural) > 10);
    }
}
