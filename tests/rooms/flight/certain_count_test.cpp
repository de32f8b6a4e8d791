// What is counted from a narrow box of states of a body (lemmas L71, L74), from above and from below, against
// the simulation of a state in it.
#include "flight/certain_count.hpp"

#include <algorithm>
#include <cmath>

#include "attacks/oracle/scalar.hpp"
#include "attacks/oracle/simulate.hpp"
#include "catch.hpp"
#include "flight/departure.hpp"
#include "rooms/number/random.hpp"
#include "rooms/number/show.hpp"

using namespace dumbbell;
using namespace dumbbell::flight;
using namespace dumbbell_test;
using dumbbell_oracle::Mass;

namespace {

constexpr long most_counted = 30;

struct Sample {
    double rho, q, e, eta;
    double width;  // of the box, from each number upwards
};

std::string show(const Sample& s) { return say("rho", s.rho, "Q", s.q, "e", s.e, "eta", s.eta); }

Sample random_sample(Random& random, double widest) {
    const double rho = random.log_uniform(0.05, 0.9);
    const double q = (1 + random.log_uniform(1e-2, 10)) / rho * 1.001;
    return {rho, q, random.log_uniform(1e-2, 1.5), random.log_uniform(1e-3, 2),
            random.log_uniform(1e-12, widest)};
}

Interval side(const Sample& s, double lo) { return {lo, lo * (1 + s.width)}; }
Body<Interval> body_of(const Sample& s) {
    return Body<Interval>::with_mass(side(s, s.rho), Interval(1) / side(s, s.q));
}

struct Counted {
    long found;
    bool doubtful;
};

// The collisions after this one, of a body of length d1 = 1: off R, or off the bridge, to the left.
Counted simulated(const Sample& s, Mass mass, bool before = false) {
    using S = long double;
    const dumbbell_oracle::Dumbbell<S> body(1, s.rho, 1 / S(s.q));
    const bool light = mass == Mass::light;
    const S e = s.e, slope = light ? s.eta - std::cos(e) : s.rho * (std::cos(e) + s.eta);
    dumbbell_oracle::State<S> after{dumbbell_oracle::pi<S>() + (light ? e : -e), -1, 0, slope};
    after.y = (light ? 1 : S(s.rho)) * std::sin(e);
    const auto run = simulate(body, before ? reversed(body.bounce(mass, after)) : after, mass);
    return {static_cast<long>(run.collisions.size()), run.care.doubtful()};
}

}  // namespace

TEST_CASE(
    "From 20,000 boxes of bodies no simulated state collides more often than counted, nor less than "
    "certain") {
    Random random(460);
    int decided = 0, again = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Sample s = random_sample(random, 1e-3);
        const auto all = departure(position(side(s, s.e)), side(s, s.eta));
        const PlainDeparture<Interval> from{all.x, all.sin_x, flight::detail::in_play(all.kappa)};
        const auto [found, doubtful] = simulated(s, Mass::light);
        const long most = plain_later_collisions(from, body_of(s), most_counted);
        const long fewest = certain_later_collisions(from, body_of(s), most_counted);
        if (!doubtful && (found > most || found < fewest)) {
            FAIL(say(show(s), "has", found, "not", fewest, "to", most));
        }
        decided += most == fewest ? 1 : 0;
        again += most == fewest && most > 3 ? 1 : 0;
    }
    CHECK(decided > 15'000);
    CHECK(again > 100);
}

TEST_CASE("From 20,000 contacts with the bridge both rays are counted, from above and from below") {
    Random random(461);
    int decided = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Sample s = random_sample(random, 1e-4);
        const auto rays = contact_rays(side(s, s.e), side(s, s.eta), body_of(s));
        for (const bool before : {false, true}) {
            const auto [found, doubtful] = simulated(s, Mass::heavy, before);
            PlainRay<Interval> ray = before ? rays.reversed : rays.outgoing;
            const long fewest = certain_count(ray, body_of(s), most_counted);
            ray.kappa = flight::detail::in_play(ray.kappa);
            const long most = plain_count(ray, body_of(s), most_counted);
            if (!doubtful && (found > most || found < fewest)) {
                FAIL(say(show(s), before ? "before" : "after", "has", found, "not", fewest, "to", most));
            }
            decided += most == fewest ? 1 : 0;
        }
    }
    CHECK(decided > 30'000);
}

TEST_CASE("Nothing is certain of what is not known, and no bound follows from it") {
    const Interval nothing = Interval(-1, 1) / Interval(0);
    const auto coin = Body<Interval>::with_mass(Interval(1), Interval(0.25));
    CHECK(certain_count(PlainRay<Interval>{nothing, Interval(0)}, coin, 9) == 0);
    CHECK(certain_count(PlainRay<Interval>{Interval(0.1), nothing}, coin, 9) == 0);
    CHECK(plain_count(PlainRay<Interval>{Interval(0.1), nothing}, coin, 9) > 9);
    CHECK(plain_count(PlainRay<Interval>{Interval(0.1), Interval(-0.2)},
                      Body<Interval>::with_mass(nothing, Interval(0.25)), 9) > 9);
}
