// The edges of the lexical classes, and what a proof says of its leaves.
#include <catch2/catch.hpp>

#include "make_adiabatic.hpp"

using namespace dumbbell_verify;
using make::closed;
using make::File;

namespace {

std::string outcome_of(const std::string& text) { return make::outcome(text); }

/// Nothing is claimed of this one ratio.
std::string claims_nothing(const std::string& ratio) {
    return closed(make::header(ratio, ratio, 1) + "piece " + ratio + " " + ratio +
                  "\nbits 53\nupper none\nlower 0\n");
}
double covered(const Proof& proof) {
    double sum = 0;
    for (const Tally& tally : proof.tallies)
        if (tally.name != "witness") sum += tally.covered;
    return sum;
}

}  // namespace

TEST_CASE("edges: words begin with a to z, versions with 0 to 9, too") {
    const std::string text = claims_nothing("2/1");
    const auto with = [&](const std::string& generator) {
        const std::string body = text.substr(0, text.find("total split"));
        return outcome_of(closed(make::replaced(body, "generator test 1.0", "generator " + generator)));
    };
    CHECK(with("zz-9. 9.0z") == "verified");
    CHECK(with("aa 0a") == "verified");
    CHECK(with("0a 0a") == "word");
    CHECK(with("9a 0a") == "word");
    CHECK(with("-a 0a") == "word");
    CHECK(with("a -1") == "word");
    CHECK(with("a .1") == "word");
    CHECK(with(std::string(32, 'a') + " 1") == "verified");
    CHECK(with(std::string(33, 'a') + " 1") == "word");
}

TEST_CASE("edges: a numerator has up to 2100 digits") {
    const auto up_to = [](std::size_t digits) {
        const std::string hi = "1" + std::string(digits - 1, '0') + "/1";
        return outcome_of(
            closed(make::header("1/1", hi, 1) + "piece 1/1 " + hi + "\nbits 53\nupper none\nlower 0\n"));
    };
    CHECK(up_to(2100) == "verified");
    CHECK(up_to(2101) == "number");
}

TEST_CASE("edges: the leaves of a proof fill its root boxes") {
    const Verified stairs = verify(DUMBBELL_PROJECT "/certificates/stairs-1-100.dbc", {});
    CHECK(stairs.roots > 2);
    CHECK(covered(stairs) == Approx(stairs.roots));
    const File file(make::falling());
    const Verified starts = verify(file.path(), {});
    CHECK(starts.roots == 1);
    CHECK(covered(starts) == Approx(1));
    const File errors(make::bounce());
    const Proof bounces = verify(errors.path(), {});
    CHECK(bounces.roots == 1);
    CHECK(covered(bounces) == Approx(1));
}

TEST_CASE("edges: what is missing is said for the ratios that were asked for, or the file's") {
    Collisions claim;
    claim.lo = 1;
    claim.hi = 2;
    claim.most = 3;
    claim.add(1, 2, 4, 4);
    CHECK(claim.missing() == "not proved: at most 3 collisions for every mass ratio in 1/1:2/1");
    Collisions asked;
    asked.lo = 1;
    asked.hi = 3;
    asked.ratios = std::pair<mpq_class, mpq_class>(2, 3);
    asked.least = 5;
    asked.add(1, 3, 4, 4);
    CHECK(asked.missing() == "not proved: at least 5 collisions for every mass ratio in 2/1:3/1");
}
