// What programs read: the verdict line, the line of several files, the JSON object, the
// codes.
#include "verify/program/summary.hpp"

#include "catch.hpp"
#include "verify/core/section.hpp"
#include "verify/program/claim_options.hpp"
#include "verify/program/json.hpp"
#include "verify/program/sentence.hpp"

using namespace dumbbell_verify;

namespace {

const Job job{"a\nb.dbc", {}};

Result result(Verdict verdict, std::uint64_t line = 0) {
    Result r;
    r.job = &job;
    r.why = {verdict, line, "count", "not\ncertified"};
    return r;
}
Result verified(bool bounded = true) {
    Result r;
    r.job = &job;
    Collisions& claim = r.proof.claim;
    claim.lo = mpq_class(3, 2);
    claim.hi = 2;
    r.proof.section = &turning();
    claim.add(claim.lo, claim.hi, bounded ? std::optional<std::uint64_t>(4) : std::nullopt, 3);
    r.proof.digest = "0f";
    r.proof.roots = 2;
    r.proof.tallies = {{"split", 1, 0}, {"count", 3, 1.5}};
    return r;
}
constexpr Verdict all[] = {Verdict::verified,    Verdict::unreadable, Verdict::open,
                           Verdict::unsupported, Verdict::limit,      Verdict::rejected};

}  // namespace

TEST_CASE("summary: a verdict line has its fields in this order") {
    Result r = verified();
    CHECK(
        verdict_line(r) ==
        "s VERIFIED scene=dumbbell ratio=3/2:2/1 upper=4 lower=3 gaps=1 open=0 widest-gap=3.34e-1 sha256=0f");
    r.proof.heavy_once = true;
    CHECK(verdict_line(r) ==
          "s VERIFIED scene=dumbbell ratio=3/2:2/1 upper=4 lower=3 gaps=1 open=0 widest-gap=3.34e-1 "
          "heavy-at-most=1 sha256=0f");
    CHECK(claim_text(verified(false).proof) ==
          "scene=dumbbell ratio=3/2:2/1 upper=none lower=3 gaps=0 open=1 widest-gap=3.34e-1");
    CHECK(verdict_line(result(Verdict::rejected, 7)) == "s REJECTED line=7 code=count not?certified");
    CHECK(verdict_line(result(Verdict::rejected)) == "s REJECTED code=count not?certified");
    CHECK(verdict_line(result(Verdict::limit, 1)) == "s LIMIT line=1 not?certified");
    CHECK(verdict_line(result(Verdict::unsupported, 2)) == "s UNSUPPORTED line=2 not?certified");
    CHECK(verdict_line(result(Verdict::unreadable)) == "s UNREADABLE not?certified");
    for (const std::string imitation : {"s VERIFIED scene=dumbbell", "c files=1 verified=1"}) {
        const Job named{imitation, {}};
        r = result(Verdict::limit);
        r.job = &named;
        CHECK(block(r, false) == "./" + imitation + "\ns LIMIT not?certified\n");
    }
}

TEST_CASE("summary: the sentence says what was demanded, or else what is proved of the ratios in question") {
    const auto said = [](const std::string& ratios, const std::string& bound) {
        Job j{"x", {}};
        std::vector<std::string> options{"--ratio", ratios};
        if (!bound.empty()) options.insert(options.end(), {bound, "4"});
        ClaimWords words;
        for (Arguments given(options); given.next();) claim_option(given, words);
        state_claim(words, j.settings);
        Result r;
        r.job = &j;
        r.proof.section = &turning();
        Collisions& claim = r.proof.claim = j.settings.demand;
        claim.lo = 1, claim.hi = 5;
        claim.add(1, 2, 3, 2);
        claim.add(2, 3, {}, 0);
        claim.add(3, 3, {}, 1);
        claim.add(3, 4, 4, 4);
        claim.add(4, 5, 4, 4);
        r.proof.heavy_once = ratios == "4";
        return std::pair(sentence(r), claim.says_nothing());
    };
    const auto proved = [](const std::string& text, const std::string& left = "max, min") {
        return std::pair("  " + text + ".\n  Not demanded: " + left + ".\n", false);
    };
    const std::string four =
        "no trajectory hits the floor more than 4 times, and some trajectory hits it 4 times";
    CHECK(said("3.5:5", "") ==
          proved("Proved: at every mass ratio from 3.5 to 5 " + four, "max, min, gap, gaps"));
    CHECK(said("1:3/2", "") ==
          proved(
              "Proved: at every mass ratio from 1 to 1.5 no trajectory hits the floor more than 3 times, and "
              "some trajectory hits it at least 2 times",
              "max, min, gap, gaps"));
    // At an end that pieces share each of them says something, and so they do together.
    CHECK(said("2", "") ==
          proved("Proved: at mass ratio 2 no trajectory hits the floor more than 3 times, and "
                 "some trajectory hits it at least 2 times"));
    CHECK(said("4", "") == proved("Proved: at mass ratio 4 " + four +
                                      "; in every trajectory the heavy mass hits the floor at most once",
                                  "max, min, heavy-at-most"));
    CHECK(
        said("3:4", "--max") ==
        proved(
            "Proved: at every mass ratio from 3 to 4 no trajectory hits the floor more than 4 times; the "
            "greatest number is known in 1 of 2 pieces, open in 1; the stretches where it is not known have "
            "a relative width of at most 0",
            "min, gap, gaps"));
    CHECK(said("10/3:4", "--min") ==
          proved("Proved: at every mass ratio from 10/3 to 4 some trajectory hits the floor at least 4 times",
                 "max, gap, gaps"));
    CHECK(said("10/3:4", "--exactly").first ==
          "  Proved: at every mass ratio from 10/3 to 4 " + four + ".\n");
    CHECK(said("1:5", "").second);
    CHECK(said("1:5", "").first ==
          "  No bound is proved that holds at every mass ratio from 1 to 5; the greatest number is known in "
          "2 of "
          "5 pieces, one of two neighbouring values in 1, open in 2; the stretches where it is not known "
          "have a "
          "relative width of at most 2.00e0.\n  Not demanded: max, min, gap, gaps.\n");
    CHECK(said("2.5", "").second);
    CHECK(said("2.5", "").first ==
          "  No bound is proved that holds at mass ratio 2.5.\n  Not demanded: max, min.\n");
    CHECK(said("3", "").first == proved("Proved: at mass ratio 3 " + four).first);
}

TEST_CASE("summary: the exit code of each verdict, and the worst of several") {
    const int codes[] = {0, 2, 3, 3, 4, 1};
    for (std::size_t i = 0; i < std::size(all); ++i) {
        CHECK(exit_code(all[i]) == codes[i]);
        for (std::size_t j = 0; j < std::size(all); ++j)
            CHECK(worst({result(all[i]), result(all[j])}) == std::max(all[i], all[j]));
    }
    CHECK(worst({}) == Verdict::verified);
}

TEST_CASE("summary: the numbers of several files") {
    std::vector<Result> results;
    std::size_t n = 0;
    for (const Verdict verdict : all) results.resize(results.size() + ++n, result(verdict));
    CHECK(
        summary_line(results) ==
        "c files=21 verified=1 rejected=6 limit=5 unsupported=4 unreadable=2 nothing-proved=3 open=0 exit=1");
    CHECK(
        summary_line({verified(false)}) ==
        "c files=1 verified=1 rejected=0 limit=0 unsupported=0 unreadable=0 nothing-proved=0 open=1 exit=0");
}

TEST_CASE("summary: JSON of a proof and of a refusal, whole") {
    CHECK(
        json(verified()) ==
        R"({"file":"a\u000ab.dbc","verdict":"VERIFIED","claim":{"scene":"dumbbell","ratio":{"lo":"3/2","hi":"2/1"},"rho":null,)"
        R"("upper":4,"lower":3,"pieces":1,"gaps":1,"open":0,"widest_gap":"1/3","heavy_at_most":null},"sha256":"0f",)"
        R"("schema":"dumbbell-verify-1","demand":{"ratio":null,"inertia":null,"rho":null,"max":null,"min":null,"gap":null,"gaps":null,)"
        R"("heavy_at_most":null,"scene":null,"claim":null,"numbers":{}},)"
        R"("leaves":{"split":1,"count":3},"coverage":{"split":0.000000,"count":0.750000},)"
        R"("work":0.000,"line":null,"code":null,"reason":null})");
    CHECK(
        json(result(Verdict::rejected, 7)) ==
        R"({"file":"a\u000ab.dbc","verdict":"REJECTED","claim":null,"sha256":null,)"
        R"("schema":"dumbbell-verify-1","demand":{"ratio":null,"inertia":null,"rho":null,"max":null,"min":null,"gap":null,"gaps":null,)"
        R"("heavy_at_most":null,"scene":null,"claim":null,"numbers":{}},)"
        R"("leaves":{},"coverage":{},"work":null,"line":7,"code":"count","reason":"not\u000acertified"})");
    CHECK(json(result(Verdict::rejected, 1)).find(R"("line":1,)") != std::string::npos);
    Result r = verified(false);
    r.proof.heavy_once = true;
    const Job asked = [] {
        Job j{"x", {}};
        j.settings.demand.ratios = std::pair<mpq_class, mpq_class>(1, 2);
        j.settings.demand.most = 5;
        j.settings.demand.least = 2;
        j.settings.claim = "collisions";
        return j;
    }();
    r.job = &asked;
    const std::string text = json(r);
    CHECK(
        verdict_line(r).ends_with(" sha256=0f demanded-ratio=1/1:2/1 max=5 min=2 demanded-claim=collisions "
                                  "not-demanded=gap,gaps,heavy-at-most"));
    CHECK(text.find(R"("upper":null,"lower":3)") != std::string::npos);
    CHECK(text.find(R"("heavy_at_most":1})") != std::string::npos);
    CHECK(
        text.find(
            R"("demand":{"ratio":{"lo":"1/1","hi":"2/1"},"inertia":null,"rho":null,"max":5,"min":2,"gap":null,)") !=
        std::string::npos);
}

TEST_CASE("summary: the work is told in seconds, rounded up") {
    Result r = verified();
    r.proof.work = 12 * dumbbell_verify::units_per_second + 1;
    CHECK(json(r).find(R"("work":12.001,)") != std::string::npos);
    r.proof.work = 999 * (dumbbell_verify::units_per_second / 1000);
    CHECK(json(r).find(R"("work":0.999,)") != std::string::npos);
}
