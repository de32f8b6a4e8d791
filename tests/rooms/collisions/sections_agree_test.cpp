// The full section (all collision states, counted forward only) proves the same number as the turning
// section: close to critical ratios on both sides, and anywhere; and so it does by plain interval evaluation.
#include <cmath>
#include <tuple>

#include "catch.hpp"
#include "collisions/certify.hpp"
#include "collisions/step_guess.hpp"
#include "critical_ratio.hpp"
#include "scale.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell_test;

namespace {

// The maximum that a section proves at one ratio; 0 if it leaves it open.
long proved(const Rational& q, Section section) {
    CertifyRequest request;
    request.claim.range = {q, q};
    request.claim.system.section = section;
    const auto pieces = certify(request);
    REQUIRE(pieces.size() == 1);
    return pieces.front().piece.status() == Status::exact ? as_long(pieces.front().piece.lower) : 0;
}

// A ratio up to `greatest`, at a relative distance of 1e-5 to `farthest` from the critical ratio at which the
// maximum becomes `n`.
struct NearCritical {
    long n;
    bool above;
    Rational q;

    [[nodiscard]] long maximum() const { return above ? n : n - 1; }
};

NearCritical near_critical(Random& choices, bool above, double greatest, double farthest) {
    // N* is about 2 + 0.886 sqrt q (theory, section 4); the second-last step is below `greatest` for certain.
    const double last = 1 + 0.8855951 * std::sqrt(greatest);
    const long n = std::lround(choices.log_uniform(4, last));
    const double distance = choices.log_uniform(1e-5, farthest);
    return {n, above, exact(guess_step(n) * (above ? 1 + distance : 1 - distance))};
}

}  // namespace

TEST_CASE("full and turning section agree close to critical ratios, on both sides") {
    Random choices(61);
    for (int i = 0; i < scaled(5); ++i) {
        const NearCritical at = near_critical(choices, i % 2 == 0, 1000, 1e-3);
        CAPTURE(at.n, at.above, at.q);
        REQUIRE(proved(at.q, Section::turning) == at.maximum());
        REQUIRE(proved(at.q, Section::full) == at.maximum());
    }
}

TEST_CASE("the full section, to 1000, and plain evaluation, to 30, agree with the turning section") {
    Random choices(65);
    for (const auto& [section, greatest, ratios] :
         {std::tuple(Section::full, 1000.0, 8), std::tuple(Section::plain, 30.0, 4)}) {
        for (int i = 0; i < scaled(ratios); ++i) {
            const Rational q = exact(choices.log_uniform(1, greatest));
            CAPTURE(q);
            const long turning = proved(q, Section::turning);
            REQUIRE(turning >= 3);
            REQUIRE(proved(q, section) == turning);
        }
    }
}

TEST_CASE("plain evaluation agrees at a hundredth and a thousandth from critical ratios too") {
    for (const long n : steps({4, 5}, {6})) {
        for (const double distance : {-1e-2, -1e-3, 1e-3, 1e-2}) {
            CAPTURE(n, distance);
            const Rational q = exact(guess_step(n) * (1 + distance));
            CHECK(proved(q, Section::plain) == (distance < 0 ? n - 1 : n));
        }
    }
}

TEST_CASE("at equal masses every section ends with two") {
    for (const Section section : {Section::turning, Section::full, Section::plain}) {
        CHECK(proved(1, section) == 2);
    }
}
