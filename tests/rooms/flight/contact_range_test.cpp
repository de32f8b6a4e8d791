#include "flight/contact_range.hpp"

#include "catch.hpp"
#include "rays.hpp"
#include "scale.hpp"

using namespace dumbbell;
using namespace dumbbell::flight;
using namespace dumbbell_test;

namespace {

// The rays between two of them, both of c >= 0.
struct RaySet {
    DoubleRay low;
    double c_hi, kappa_hi;

    template <class I>
    [[nodiscard]] std::optional<ContactRange<I>> contact() const {
        return contact_range(I(low.c, c_hi), I(low.kappa, kappa_hi));
    }
};

RaySet around(Random& random, const DoubleRay& ray, double size) {
    const double c_hi = ray.c + size * random.uniform(0, 1) * (random.coin() ? 1 : ray.c);
    return {ray, c_hi, std::min(0.9999, ray.kappa + size * random.uniform(0, 1))};
}

// True if there was something to check.
template <class I, class T>
bool check(Random& random, const RaySet& set) {
    const auto contact = set.contact<I>();
    if (!contact) {
        return false;
    }
    for (int i = 0; i < 4; ++i) {
        const double c = i == 0 ? set.low.c : i == 1 ? set.c_hi : random.uniform(set.low.c, set.c_hi);
        const double kappa = i == 0   ? set.low.kappa
                             : i == 1 ? set.kappa_hi
                                      : random.uniform(set.low.kappa, set.kappa_hi);
        const auto exact = exact_flight(T(c), T(kappa));
        const bool ok = exact.hits && encloses(contact->x, exact.x) &&
                        encloses(contact->at.sin, T(sin(exact.x))) &&
                        encloses(contact->at.cos, T(cos(exact.x)));
        if (!ok) {
            FAIL(say("rays from", set.low, "to", set.c_hi, set.kappa_hi, "one", c, kappa, "x", exact.x));
        }
    }
    return true;
}

}  // namespace

TEST_CASE("L12: the range of contacts holds those of all rays of the set") {
    Random random(141);
    const long sets = scaled(600);
    int checked = 0;
    for (int i = 0; i < sets; ++i) {
        const RaySet set = around(random, random_ray(random), random.coin() ? 0 : random.scaled(1e-16, 0.3));
        checked += check<Interval, Real>(random, set) ? 1 : 0;
        const PrecisionScope scope(20 + random.below(200));
        checked += check<BigInterval, Decimal<100>>(random, set) ? 1 : 0;
    }
    CHECK(checked > sets);
}

TEST_CASE("Contacts are found where the rays clearly collide, and never if one of them misses") {
    Random random(142);
    int found = 0;
    for (int i = 0; i < 1'000; ++i) {
        const double kappa = random.uniform(0, 0.3);
        found += around(random, {random.uniform(0, 0.3), kappa, 1}, 1e-3).contact<Interval>() ? 1 : 0;
        const DoubleRay below = grazing_ray(kappa, -random.scaled(1e-9, 0.1), 1);
        const DoubleRay above = grazing_ray(kappa, random.scaled(1e-9, 0.1), 1);
        REQUIRE_FALSE(contact_range(Interval(below.c, above.c), Interval(kappa)));
        REQUIRE_FALSE(contact_range(Interval(above.c), Interval(kappa)));
    }
    CHECK(found == 1'000);
}

TEST_CASE("The range is hardly wider than the contacts of the rays at its ends") {
    Random random(143);
    const PrecisionScope scope(200);
    for (int i = 0; i < 300; ++i) {
        const double size = random.scaled(1e-12, 1e-5);
        const RaySet set = around(random, {random.uniform(0.01, 0.3), random.uniform(0, 0.3), 1}, size);
        const auto contact = set.contact<BigInterval>();
        REQUIRE(contact);
        const Real true_width = exact_flight(Real(set.c_hi), Real(set.kappa_hi)).x -
                                exact_flight(Real(set.low.c), Real(set.low.kappa)).x;
        REQUIRE(width(contact->x) <= true_width.convert_to<double>() * (1 + 100 * size) + 1e-45);
    }
}

TEST_CASE("Beyond 1000 bits the range of contacts is as narrow as the working precision") {
    for (const int bits : {128, 1024, 2048, 4096}) {
        INFO(bits << " bits");
        const PrecisionScope scope(bits);
        const auto contact = contact_range(BigInterval(0.1), BigInterval(0.2));
        REQUIRE(contact);
        CHECK(certainly_less(high_end(contact->x) - low_end(contact->x), power_of_half(bits - 12)));
    }
}

TEST_CASE("Nothing is certain about contacts of rays that are not numbers") {
    const Interval bad(not_a_number);
    CHECK_FALSE(contact_range(bad, Interval(0.1)));
    CHECK_FALSE(contact_range(Interval(0.1), bad));
    CHECK_FALSE(contact_range(BigInterval(not_a_number), BigInterval(0.1)));
    CHECK_FALSE(contact_range(BigInterval(0.1), BigInterval(not_a_number)));
}
