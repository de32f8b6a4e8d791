#include "flight/batch/bounce.hpp"

#include <optional>
#include <type_traits>

#include "catch.hpp"
#include "flight/batch/lower_bounce.hpp"
#include "flight/batch/upper_bounce.hpp"
#include "places.hpp"

using namespace dumbbell;
using namespace dumbbell::flight;
using namespace dumbbell_test;

// L39 is about every ray with c >= 0, -1 <= kappa < 1, 0 < r <= 1 and every z of [0, half_pi_hi]: here they
// are as extreme as doubles allow, and r is at least 2^-900. Any point x near z is taken as the contact
// itself, which it is for another c: so the next state is checked wherever z lies, and not only near
// contacts.

namespace {

struct Laid {
    DoubleRay ray;
    double z;
};

double extreme_r(Random& random) {
    switch (random.below(4)) {
        case 0:
            return random.scaled(0x1p-900, 1);
        case 1:
            return random.scaled(1e-17, 1e-11);
        default:
            return random_r(random, 1e-10);
    }
}

double extreme_kappa(Random& random, double r) {
    switch (random.below(7)) {
        case 0:
            return random.coin() ? -r : -1.0;
        case 1:
            return 1 - random.scaled(0x1p-53, 0.5);
        case 2:
            return random.sign() * random.scaled(least, 0.5);
        case 3:
            return r * random.uniform(-1, 3);
        default:
            return random.uniform(-1, 1);
    }
}

Laid extreme_place(Random& random) {
    const double r = extreme_r(random);
    const double kappa = std::min(extreme_kappa(random, r), neighbour(1, -1));
    const double top = std::acos(std::max(kappa, 0.0));
    const double peak = std::max(0.0, std::sin(top) - kappa * top);
    const double x = random.coin() ? random.uniform(0, top) : top * random.scaled(1e-14, 1);
    const double heights[] = {0,
                              random.scaled(least, 1),
                              peak * (1 + random.sign() * random.scaled(1e-17, 0.1)),
                              std::max(0.0, std::sin(x) - kappa * x),
                              std::max(0.0, std::sin(x) - kappa * x),
                              random.below(20) == 0 ? greatest : random.scaled(0.5, 4)};
    const double c = heights[random.below(6)];
    const double near = x * (1 + random.sign() * random.scaled(1e-17, 0.1));
    const double places[] = {0,
                             half_pi_hi,
                             near,
                             near,
                             random.scaled(least, 1),
                             random.uniform(0, half_pi_hi),
                             batch::first_point(c, kappa)};
    return {{c, kappa, r}, std::clamp(places[random.below(7)], 0.0, half_pi_hi)};
}

/// sin x - kappa x - c, and by how much it may be off.
Real gap(const DoubleRay& ray, const Real& x) { return sin(x) - ray.kappa * x - ray.c; }
Real tolerance(const DoubleRay& ray, const Real& x) { return Real("1e-55") * (x + ray.c); }

/// What L4 says of a ray of this slope that meets the wall at x; nothing if it does not come back.
struct Next {
    Real c, kappa;
};
std::optional<Next> after(const DoubleRay& ray, const Real& x) {
    const Real w = cos(x);
    const Real d = w * w - 2 * ray.kappa * w - ray.r;
    if (!(d > Real("1e-55"))) {
        return std::nullopt;
    }
    const Real kappa = (ray.kappa * w * w + 2 * ray.r * w - Real(ray.r) * ray.kappa) / d;
    return Next{sin(x) + kappa * (x + pi_in<Real>()), kappa};
}

/// The contact's bound, or, for the claims about what follows, any shift that L39 admits.
double admitted(Random& random, const Place& place, const batch::Contact<double>& contact) {
    if (contact.close && random.coin()) {
        return contact.shift;
    }
    const double most = std::min(place.least, 0x1p-25);
    const double size = random.coin() ? most : random.scaled(0x1p-1000, 0x1p-25);
    return std::max(random.sign() * std::min(size, most + 0x1p-960), -place.z);
}

/// By how much a sine or cosine is off, in units of 2^-53.
Real off(double found, const Real& exact) { return abs(Real(found) - exact) / exact * Real(0x1p53); }

}  // namespace

TEST_CASE("L39 (a)-(d): lower bounds hold for rays and tangents as extreme as doubles allow") {
    Random random(441);
    int bounded = 0;
    int followed = 0;
    for (int i = 0; i < 100'000; ++i) {
        const auto [ray, start] = extreme_place(random);
        const Real top = ray.kappa > 0 ? Real(acos(Real(ray.kappa))) : Real(pi_in<Real>() / 2);
        const auto broken = [&, &ray = ray](const char* what, double z) { FAIL(say(what, ray, "z", z)); };
        if (batch::strict_miss(start, batch::sin_cos(start), ray.c, ray.kappa) && gap(ray, top) >= 0) {
            broken("(b): no miss", start);
        }
        const auto place = some_place(random, ray, start);
        if (!place) {
            continue;
        }
        const double z = place->z;
        if (batch::strict_miss(z, place->at, ray.c, ray.kappa) && gap(ray, top) >= 0) {
            broken("(b): no miss", z);
        }
        ++bounded;
        const auto contact = batch::Lower::contact(*place, ray.c, ray.kappa);
        const Real bound = Real(z) + Real(contact.shift);
        const Real end = std::min(bound, top);
        if (bound < 0 || gap(ray, end) > tolerance(ray, end)) {
            broken("(a): a contact before the bound", z);
        }
        const double shift = admitted(random, *place, contact);
        const Real x = Real(z) + Real(shift);
        if (x > pi_in<Real>() / 2) {
            continue;
        }
        const auto next = batch::Lower::bounce(z, place->at, shift, ray.kappa, ray.r * batch::Lower::outward);
        const auto exact = after(ray, x);
        if (!exact) {
            continue;
        }
        if (next.ends) {
            broken("(d): ends too early", z);
        }
        if (next.follows) {
            ++followed;
            if (!(next.kappa > 0 && Real(next.kappa) <= exact->kappa && next.c >= 0 &&
                  Real(next.c) <= exact->c)) {
                broken("(c), (d): no lower state", z);
            }
        }
    }
    CHECK(bounded > 40'000);
    CHECK(followed > 20'000);
}

TEST_CASE("L39 (e), (f): upper bounds hold for rays and tangents as extreme as doubles allow") {
    Random random(442);
    int certain = 0;
    int followed = 0;
    for (int i = 0; i < 100'000; ++i) {
        const auto [ray, start] = extreme_place(random);
        const auto place = some_place(random, ray, start);
        if (!place) {
            continue;
        }
        const double z = place->z;
        const auto contact = batch::Upper::contact(*place, ray.c, ray.kappa);
        if (contact.close) {
            ++certain;
            const Real bound = Real(z) + Real(contact.shift);
            if (bound < 0 || bound > pi_in<Real>() / 2 || gap(ray, bound) <= -tolerance(ray, bound)) {
                FAIL(say("(e): no contact up to the bound:", ray, "z", z));
            }
        }
        const double shift = admitted(random, *place, contact);
        const Real x = Real(z) + Real(shift);
        if (x > pi_in<Real>() / 2) {
            continue;
        }
        const auto next = batch::Upper::bounce(z, place->at, shift, ray.kappa, ray.r * batch::Upper::outward);
        if (!next.follows || ray.kappa < -ray.r) {  // no ray of the domain is as flat as that
            continue;
        }
        ++followed;
        const auto exact = after(ray, x);
        if (!exact || !(Real(next.kappa) >= exact->kappa && Real(next.c) >= exact->c)) {
            FAIL(say("(f): no upper state:", ray, "z", z));
        }
    }
    CHECK(certain > 10'000);
    CHECK(followed > 20'000);
}

TEST_CASE("L39 (f): the cosine at a contact is bounded, also close to the peak") {
    Random random(443);
    int followed = 0;
    for (int i = 0; i < 20'000; ++i) {
        const double z = half_pi_hi - random.scaled(1e-15, 1e-9);
        const auto at = batch::sin_cos(z);
        const double shift = at.cos * 0x1p-8 * random.sign() * random.uniform(0, 1);
        const double w = at.cos - shift;
        const DoubleRay ray{0, 0, w * w * random.uniform(0.1, 0.9)};
        const auto next = batch::Upper::bounce(z, at, shift, ray.kappa, ray.r * batch::Upper::outward);
        const auto exact = after(ray, Real(z) + Real(shift));
        if (next.follows) {
            ++followed;
            if (!exact || !(Real(next.kappa) >= exact->kappa)) {
                FAIL(say("no upper state:", ray, "z", z, "shift", shift));
            }
        }
    }
    CHECK(followed > 10'000);
}

TEST_CASE("L39 (h): a place that is near has its sine, cosine, inverse and room") {
    Random random(444);
    int near_ones = 0;
    for (int i = 0; i < 200'000; ++i) {
        auto [ray, z] = extreme_place(random);
        const auto at = batch::sin_cos(z);
        if (random.coin()) {  // such that the step is about as long as admitted
            const double slope = at.cos - ray.kappa;
            const double step = std::min({0x1p-13, at.sin * 0x1p-8, at.cos * 0x1p-8, slope * 0x1p-6});
            ray.c =
                std::max(0.0, at.sin - ray.kappa * z + random.sign() * step * slope * random.uniform(0.9, 1));
        }
        const auto [place, near] = batch::place_near(z, at, ray.c, ray.kappa);
        if (!near) {
            continue;
        }
        ++near_ones;
        const Real x = place.z;
        const Real slope = cos(x) - Real(ray.kappa);
        const auto broken = [&, &ray = ray, &z = z](const char* what) { FAIL(say(what, ray, "z", z)); };
        if (!(place.z >= 0 && place.z <= half_pi_hi)) {
            broken("outside");
        }
        if (x > Real(0x1p-900) && !(off(place.at.sin, sin(x)) < Real(5.4))) {
            broken("sine");
        }
        if (!(off(place.at.cos, cos(x)) < Real(5.4))) {
            broken("cosine");
        }
        if (!(abs(Real(place.inverse) * slope - 1) < Real(0x1p-17)) || !(slope > 0)) {
            broken("inverse");
        }
        if (!(Real(place.least) * 128 <= std::min(Real(sin(x)), Real(cos(x))))) {
            broken("room");
        }
    }
    CHECK(near_ones > 50'000);
}

TEST_CASE("L39 (h): sine and cosine are moved to within 5.4 u, however far that is admitted") {
    Random random(445);
    Real worst = 0;
    for (int i = 0; i < 100'000; ++i) {
        const double z = random.coin()   ? random.uniform(0, half_pi_hi)
                         : random.coin() ? random.scaled(1e-250, 1)
                                         : half_pi_hi - random.scaled(1e-15, 1);
        const auto at = batch::sin_cos(z);
        const double most = std::min(0x1p-13, std::min(at.sin, at.cos) * 0x1p-8);
        const double x = z + random.sign() * most * (random.coin() ? 1.0 : random.uniform(0, 1));
        const auto found = moved(at, x - z);
        REQUIRE(Real(x - z) == Real(x) - Real(z));
        worst = std::max({worst, off(found.sin, sin(Real(x))), off(found.cos, cos(Real(x)))});
    }
    CHECK(worst < Real(5.4));
    CHECK(worst > Real(1));
}

TEST_CASE("The place of a step from near the contact is still nearer to it") {
    Random random(446);
    int near_ones = 0;
    for (int i = 0; i < 20'000; ++i) {
        const DoubleRay ray = random_ray(random);
        const auto exact = exact_flight(Real(ray.c), Real(ray.kappa));
        if (!exact.hits || exact.clearance < 1e-3) {
            continue;
        }
        const double z =
            std::clamp(exact.x.convert_to<double>() * (1 + random.sign() * 1e-5), 0.0, half_pi_hi);
        const auto [place, near] = batch::place_near(z, batch::sin_cos(z), ray.c, ray.kappa);
        near_ones += near ? 1 : 0;
        if (near && abs(Real(place.z) - exact.x) > exact.x * Real(1e-11)) {
            FAIL(say("far:", ray, "from", z, "to", place.z, "not", exact.x));
        }
    }
    CHECK(near_ones > 5'000);
}

TEMPLATE_TEST_CASE(
    "Close bounds are close: within 1e-14 from below, 1e-13 from above, relative to the angle of incidence",
    "", batch::Lower, batch::Upper) {
    constexpr bool from_below = std::is_same_v<TestType, batch::Lower>;
    const Real relative = from_below ? 1e-14 : 1e-13, absolute = from_below ? 1e-299 : 1e-269;
    Random random(412);
    int close = 0;
    for (int i = 0; i < 20'000; ++i) {
        const DoubleRay ray = random_ray(random);
        const auto exact = exact_flight(Real(ray.c), Real(ray.kappa));
        if (!exact.hits || exact.clearance < 1e-3) {
            continue;
        }
        const Real x = close_contact<TestType>(ray, exact);
        ++close;
        const Real beyond = from_below ? Real(exact.x - x) : Real(x - exact.x);
        if (beyond < 0 || beyond * (cos(exact.x) - Real(ray.kappa)) > relative * exact.x + absolute) {
            FAIL(say("no bound, or loose:", ray, "x", exact.x, x));
        }
    }
    CHECK(close > 5'000);
}

TEMPLATE_TEST_CASE("what was decided by less than a thousandth is not clear", "", batch::Lower,
                   batch::Upper) {
    const auto clear = [](double z, double r) {
        return TestType::bounce(z, batch::sin_cos(z), 0.0, 0.0, r).clear;
    };
    // By the slope of the wall at the contact, and by how much the ray turns back.
    CHECK(clear(half_pi_hi - 0x1.8p-9, 1e-9));
    CHECK_FALSE(clear(half_pi_hi - 0x1.8p-11, 1e-9));
    const double square = std::cos(1.0) * std::cos(1.0);
    CHECK(clear(1, square * (1 - 0x1p-9)));
    CHECK_FALSE(clear(1, square * (1 - 0x1p-11)));
}
