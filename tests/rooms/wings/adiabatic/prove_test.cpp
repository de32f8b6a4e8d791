#include "adiabatic/prove.hpp"

#include <cmath>

#include "adiabatic/search.hpp"
#include "base/error.hpp"
#include "catch.hpp"
#include "scale.hpp"

using namespace dumbbell;
using namespace dumbbell::adiabatic;

namespace {

Request request(Claim claim, const Rational& lo, const Rational& hi, const Rational& margin) {
    Request result;
    result.of.claim = claim;
    result.of.delta = {lo, hi};
    result.of.heights = {Rational(0), claim == Claim::run ? Rational(9, 10) : Rational(1)};
    result.of.margin = margin;
    return result;
}

double ratio(const Proof& proof, std::size_t i = 0) {
    return Rational(proof.bounds.at(i) / proof.attained.at(i).value).convert_to<double>();
}

std::string refusal(Hypotheses of) {
    try {
        require_sensible(of);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

}  // namespace

TEST_CASE(
    "Theorem 3.3 at delta = 0.01, and for an interval: the bound is within 1.25 of an orbit, whatever the "
    "number of threads") {
    Request one = request(Claim::run, Rational(1, 100), Rational(1, 100),
                          scaled(1) < 20 ? Rational(1, 2) : Rational(3, 10));
    const Proof proof = prove(one);
    REQUIRE(proof.complete());
    CHECK(ratio(proof) < 1.25);
    CHECK(ratio(proof) >= 1);
    if (scaled(1) < 20) return;  // what follows takes seconds
    one.jobs = 3;
    const Proof again = prove(one);
    CHECK(again.bounds == proof.bounds);
    CHECK(again.tree == proof.tree);
    CHECK(again.attained.at(0).u == proof.attained.at(0).u);
    const Proof interval = prove(request(Claim::run, Rational(0), Rational(1, 200), Rational(1, 2)));
    REQUIRE(interval.complete());
    CHECK(ratio(interval) < 1.25);
}

TEST_CASE("Lemma 3.1 and Corollary 3.2 at delta = 0.01: within 1.25 of a state") {
    for (const int exponent : {0, 4, 8, 12}) {
        Request one = request(Claim::bounce, Rational(1, 100), Rational(1, 100), Rational(1));
        one.of.exponent = exponent;
        const Proof proof = prove(one);
        CAPTURE(exponent);
        REQUIRE(proof.complete());
        CHECK(ratio(proof, 0) < 1.25);
        CHECK(ratio(proof, 1) < 1.25);
    }
}

TEST_CASE("Theorem 3.5 at one delta within 2 of an orbit") {
    const bool far = scaled(1) >= 20;
    const Rational delta = far ? Rational(1, 100) : Rational(1, 10);
    const Proof proof = prove(request(Claim::scattering, delta, delta, far ? Rational(1, 2) : Rational(1)));
    REQUIRE(proof.complete());
    CHECK(ratio(proof) < 2);
}

TEST_CASE("A long orbit ends where it is interrupted, in the search and in its enclosure") {
    const Rational least(1, 1'000'000);
    Search search;
    search.of = request(Claim::run, least, least, Rational(3, 10)).of;
    int asked = 0;
    search.interrupted = [&] { return ++asked == 3; };
    Sample sample = simulated(search, 0.6, 1, 0);
    CHECK(asked == 3);
    CHECK(sample.n > 256);
    CHECK(sample.n < 3 * 256);
    search.interrupted = never;
    CHECK(attained(search, sample));
    search.interrupted = [] { return true; };
    CHECK_FALSE(attained(search, sample));
}

TEST_CASE("What is interrupted claims nothing") {
    Request one = request(Claim::run, Rational(1, 100), Rational(1, 100), Rational(3, 10));
    one.interrupted = [] { return true; };
    const Proof proof = prove(one);
    CHECK_FALSE(proof.complete());
    CHECK(proof.bounds.empty());
}

TEST_CASE("An orbit is attained only if it satisfies the hypotheses") {
    Search search;
    search.of = request(Claim::run, Rational(1, 100), Rational(1, 100), Rational(3, 10)).of;
    Sample sample = simulated(search, 0.5, 1, 0);
    REQUIRE(sample.n > 10);
    const auto state = attained(search, sample);
    REQUIRE(state);
    CHECK(state->value.convert_to<double>() == Approx(sample.error).epsilon(1e-4));
    CHECK(state->value.convert_to<double>() < sample.error);
    sample.u = 0.31;  // higher than 0.9
    CHECK_FALSE(attained(search, sample));
    sample.u = 0.5;
    sample.n += 40;  // nearer the vertical than the margin
    CHECK_FALSE(attained(search, sample));
}

TEST_CASE("Hypotheses that make no sense are refused with what to do") {
    const Hypotheses good = request(Claim::run, Rational(1, 100), Rational(1, 100), Rational(3, 10)).of;
    CHECK(refusal(good).empty());
    const auto with = [&](const auto& change) {
        Hypotheses of = good;
        change(of);
        return refusal(of);
    };
    CHECK_THAT(with([](auto& of) {
                   of.delta = {Rational(1, 2), Rational(1, 2)};
               }),
               Contains("--delta must lie between 0 and 1/2"));
    CHECK_THAT(with([](auto& of) {
                   of.delta = {Rational(0), Rational(0)};
               }),
               Contains("--delta must lie between 0 and 1/2"));
    CHECK_THAT(with([](auto& of) {
                   of.claim = Claim::bounce;
                   of.delta.first = 0;
               }),
               Contains("thm3.3 only"));
    const Rational tiny(1, 1'000'001);
    CHECK_THAT(with([&](auto& of) {
                   of.delta = {tiny, tiny};
               }),
               Contains("at least 1e-6") && Contains("a range 0:D"));
    CHECK_THAT(with([&](auto& of) {
                   of.claim = Claim::scattering;
                   of.delta.first = tiny;
               }),
               Contains("at least 1e-6") && !Contains("0:D"));
    const auto bounce_from = [&](const Rational& delta) {
        return with([&](auto& of) {
            of.claim = Claim::bounce;
            of.delta.first = delta;
        });
    };
    CHECK(bounce_from(tiny).empty());
    CHECK_THAT(bounce_from(tiny * tiny), Contains("at least 1e-12"));
    CHECK_THAT(with([](auto& of) { of.margin = 0; }), Contains("reaches the vertical"));
    CHECK_THAT(with([](auto& of) { of.margin = 2; }), Contains("at most 1"));
    CHECK_THAT(with([](auto& of) { of.heights = {Rational(1, 2), Rational(1, 2)}; }), Contains("LO < HI"));
    CHECK_THAT(with([](auto& of) {
                   of.heights = {Rational(99, 100), Rational(1)};
               }),
               Contains("no state has these heights"));
}
