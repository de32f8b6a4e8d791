// How often incoming trajectories hit the floor on average: the leaves' bounds, Theorem 6 or L85, and the
// verifier's sums, against each other and against known values.
#include "starts/answer/mean.hpp"

#include <cmath>

#include "base/error.hpp"
#include "catch.hpp"
#include "rooms/wings/starts/sample.hpp"
#include "starts/cover/certificate.hpp"
#include "starts/cover/incoming.hpp"
#include "starts/cover/subdivide.hpp"
#include "verify/wings/starts/claim.hpp"
#include "verify/wings/starts/demand.hpp"
#include "verify/wings/starts/mean.hpp"

using namespace dumbbell;
using namespace dumbbell::starts;

namespace {

/// (E(-q) + E(-q rho^2))/pi and E(-q rho^2)/pi to twelve digits, by mpmath. Without rho: of dumbbells.
struct Known {
    const char* q;
    double all, heavy;
    std::optional<Rational> rho{};
};
const Known known_means[] = {{"1", 1.21600672342498, 0.60800336171249},
                             {"4.61", 1.40336170951618, 0.526101395957853},
                             {"10", 1.67064850287258, 0.512274888056721},
                             {"10", 1.67064850287258, 0.512274888056721, Rational(1, 10)},
                             {"100", 3.75095634736935, 0.501247665962553},
                             {"1000", 10.5928414901153, 0.50012497657226},
                             {"1e6", 318.811285925111, 0.500000124999977},
                             {"4", 1.67760997186220, 0.838804985931099, 1},
                             {"9", 1.82718876230440, 0.715139925305567, Rational(1, 2)},
                             {"0.5", 1.07288276867303, 0.515276653286578, Rational(1, 2)}};

bool holds(const BigInterval& x, double y) { return x.lo() <= y + 1e-11 * y && y - 1e-11 * y <= x.hi(); }

}  // namespace

TEST_CASE(
    "the exact mean is that of the elliptic integrals, and the verifier's sums contain it to a millionth") {
    for (const Known& known : known_means) {
        INFO("q = " << known.q);
        const Rational q = parse_rational(known.q);
        const ExactMean exact = exact_mean(q, known.rho);
        CHECK(holds(exact.all, known.all));
        CHECK(holds(exact.heavy, known.heavy));
        CHECK(exact.all.hi() - exact.all.lo() < 1e-14 * known.all);
        if (known.rho) {
            continue;
        }
        const auto sums = dumbbell_verify::starts::means(mpq_class(q.raw()));
        CHECK((sums.all.lo <= exact.all.lo() && exact.all.hi() <= sums.all.hi));
        CHECK((sums.heavy.lo <= exact.heavy.lo() && exact.heavy.hi() <= sums.heavy.hi));
        CHECK(sums.all.hi - sums.all.lo < 1e-6 * std::max(1.0, known.all / 10));
    }
}

TEST_CASE("the mean of certified histograms contains the exact one, of bodies too") {
    const auto parts_of = [](const Box& all, std::size_t boxes = 2000) {
        return subdivide(all, {.max_boxes = boxes, .jobs = 2, .incoming = true});
    };
    std::vector<Box> tried{incoming_box(4, 1), incoming_box(9, Rational(1, 2)),
                           incoming_box(Rational(1, 2), Rational(1, 2))};
    for (const char* q : {"1", "4.61", "10", "100", "1000"}) tried.push_back(incoming_box(parse_rational(q)));
    for (const Box& all : tried) {
        INFO("q = " << to_fraction(all.lower(Axis::ratio)) << (all.rho ? ", a body" : ""));
        const auto parts = parts_of(all);
        const MeanBounds bounds = mean_bounds(parts.tree);
        const ExactMean exact = exact_mean(all.lower(Axis::ratio), all.rho);
        REQUIRE(bounds.hi);
        CHECK(bounds.lo < exact_lo(exact.all));
        CHECK(exact_hi(exact.all) < *bounds.hi);
        CHECK_THAT(mean_text(all, parts.tree), Contains("By the boxes the mean is between "));
    }
    CHECK_THROWS_AS(mean_text(incoming_box(1'000'000), parts_of(incoming_box(10)).tree), BrokenInvariant);
    const Box beyond = incoming_box(parse_rational("1e40"));  // open leaves only, and E(-1/q)/pi nearly 1/2
    CHECK_THAT(mean_text(beyond, parts_of(beyond, 2).tree),
               Contains("probability 0.500000000000... = ") && Contains("the mean is at least 0."));
}

TEST_CASE("shares with another mean than that of Theorem 6 are refused") {
    dumbbell_verify::starts::Claim claim;
    claim.incoming = true;
    claim.box.lo.back() = claim.box.hi.back() = 10;  // 1.670649...
    claim.asked_box = claim.box;
    const auto refusal = [&](std::uint64_t least, std::uint64_t most) {
        claim.shares.emplace();
        claim.shares->add(least, most, 1);
        return missing(claim, {}, {});
    };
    CHECK(refusal(1, 2).empty());
    CHECK_THAT(refusal(1, 1), Contains("Theorem 6"));
    CHECK_THAT(refusal(2, 4), Contains("Theorem 6"));
    CHECK_THAT(claim.paragraph(), Contains("is 2.000000 to 4.000000 by the leaves, and 1.670648"));
    claim.shares->add(0, 0, 1);
    claim.shares->open = 1;
    CHECK_THAT(claim.paragraph(), Contains("is at least 2.000000 by the leaves"));
    CHECK_THAT(claim.json(), Contains(R"("mean":{"lo":"2/1","hi":null,"exact":["1.67064)"));
    claim.incoming = false;
    CHECK(missing(claim, {}, {}).empty());
}
