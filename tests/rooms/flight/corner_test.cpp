#include "flight/corner.hpp"

#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "flight/paper_bound.hpp"
#include "rooms/number/random.hpp"

using namespace dumbbell;
using dumbbell::flight::corner_count;

TEST_CASE("The corner of a coin takes 4 collisions, of a uniform rod exactly 3, of a massless one 2") {
    CHECK(corner_count(1, 4, 100) == 4);
    CHECK(corner_count(1, 3, 100) == 3);
    CHECK(corner_count(1, Rational(3'000'001, 1'000'000), 100) == 4);
    CHECK(corner_count(1, 1, 100) == 2);
    CHECK(corner_count(Rational(1, 10), 10, 100) == 2);
    CHECK(corner_count(Rational(1, 10), Rational(10'000'001, 1'000'000), 100) == 3);
}

TEST_CASE("A corner count stops behind the most that is asked for") {
    CHECK(corner_count(1, 4, 4) == 4);
    CHECK(corner_count(1, 4, 3) == 4);
    CHECK(corner_count(1, 1'000'000, 10) == 11);
}

TEST_CASE("The corner of a symmetric body is the wedge of the source paper's bound") {
    dumbbell_test::Random random(46);
    for (int i = 0; i < 300; ++i) {
        const Rational q = exact(1 + random.log_uniform(1e-6, 1e5));
        CHECK(corner_count(1, q, 1000) == flight::paper_bound(q) - 1);
    }
}

TEST_CASE("The corner of any body is counted as angles count it") {
    dumbbell_test::Random random(47);
    for (int i = 0; i < 2000; ++i) {
        const double rho = random.log_uniform(0.01, 1), q = (1 + random.log_uniform(1e-3, 100)) / rho;
        const double turns =
            std::numbers::pi / (std::numbers::pi - std::atan(std::sqrt(q)) - std::atan(rho * std::sqrt(q)));
        if (std::abs(turns - std::round(turns)) > 1e-6) {
            CHECK(corner_count(exact(rho), exact(q), 1000) == std::lround(std::ceil(turns)));
        }
    }
}
