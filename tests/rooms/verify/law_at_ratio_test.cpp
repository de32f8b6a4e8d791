// Files about one mass ratio by the law: what they may say, and on which file they rest.
#include <catch2/catch.hpp>

#include "law_truth.hpp"
#include "make_law.hpp"
#include "run_program.hpp"
#include "verify/law/constants.hpp"
#include "verify/law/file.hpp"
#include "verify/number/big.hpp"

using dumbbell_verify::Collisions, dumbbell_verify::Failure, dumbbell_verify::LawAtRatio,
    dumbbell_verify::LawFile, dumbbell_verify::Settings, dumbbell_verify::Verdict;
using make::run;

namespace {

const std::string shipped_law = DUMBBELL_PROJECT "/certificates/law.dbc.gz";
const std::string law_digest = "65bdaf5f0fd292bb0101b000705b604b169a2b935633567d5b87e6d8b47ad5fd";

std::string by_law(const std::string& ratio, const std::string& upper, const std::string& lower,
                   const std::string& law = law_digest) {
    return make::hashed(
        "dumbbell-certificate 1\ngenerator test 1.0\nlemmas 1\nscene dumbbell\nsection none\n"
        "claim collisions-by-law\nratio " +
        ratio + "\nlaw " + law + "\nupper " + upper + "\nlower " + lower + "\n");
}
std::string by_law_mutant(const std::string& from, const std::string& to) {
    const std::string text = make::replaced(by_law("10/1", "4", "4"), from, to);
    return make::hashed(text.substr(0, text.find("sha256")));
}

/// The shipped file is verified once for all tests.
Settings with_law() {
    static const auto law = std::make_shared<LawFile>(shipped_law);
    Settings settings;
    settings.law = law;
    return settings;
}
std::string outcome_with_law(const std::string& text) { return make::outcome(text, with_law()); }
std::string says(const std::string& ratio, const std::string& upper, const std::string& lower) {
    return outcome_with_law(by_law(ratio, upper, lower));
}
std::string ten_to(std::size_t power) { return "1" + std::string(power, '0'); }

struct Edge {
    long N;
    bool beyond;
    std::string k;
};
const std::vector<Edge> edges{
    {903, false, "1744146334385707174745041463066548417785166972920421238671892906111926273"},
    {903, true, "1744151709611889846906028859388319775780350092299960975386936093555294208"},
    // Here even the two ends of what encloses the bound are told apart.
    {8308, true, "148222004202681340390376635322724778662894134022141074967745256490486726656"}};
/// The least k for which q = k/2^220 is beyond the step to N for certain, or for which it is not certain that
/// q is not beyond it, next to the q with C sqrt q = N - 2.
mpz_class edge(long N, bool beyond) {
    const double root = static_cast<double>(N - 2) / 0.88559512945;
    const auto is_past = [&](const mpz_class& k) {
        mpq_class q(k, mpz_class(1) << 220);
        q.canonicalize();
        const std::string ratio = dumbbell_verify::to_string(q);
        return beyond ? says(ratio, std::to_string(N), std::to_string(N)) == "verified"
                      : says(ratio, std::to_string(N - 1), std::to_string(N - 1)) != "verified";
    };
    mpz_class no = mpz_class(root * root - 5) << 220, yes = mpz_class(root * root + 50) << 220;
    REQUIRE_FALSE(is_past(no));
    REQUIRE(is_past(yes));
    while (yes - no > 1) {
        const mpz_class k = (no + yes) / 2;
        (is_past(k) ? yes : no) = k;
    }
    return yes;
}

const std::string at_1e100 = "88559512945271391141202194891455767300579529460287";

}  // namespace

// One case, so that all of it verifies the law once.
TEST_CASE("by law: what is verified at a ratio, and what is not") {
    SECTION("N is verified where the steps or Theorem A prove it, and no other number is") {
        for (const auto& [ratio, n] :
             std::vector<std::pair<std::string, std::uint64_t>>{{"1/1", 2},
                                                                {"1000001/1000000", 3},
                                                                {"8/7", 3},
                                                                {"32/7", 3},
                                                                {"24/5", 4},
                                                                {"10/1", 4},
                                                                {"11/1", 4},
                                                                {"103/9", 5},
                                                                {"100/1", 10},
                                                                {"1000/1", 29},
                                                                {"313/5", 8},
                                                                {"251/4", 9},
                                                                {"1032803/1", 901},
                                                                {"2065619/2", 902},
                                                                {"1035103/1", 902},
                                                                {"1035107/1", 903},
                                                                {"1000000/1", 887},
                                                                {ten_to(24) + "/1", 885595129454}}) {
            INFO(ratio << " " << n);
            const auto text = [](std::uint64_t x) { return std::to_string(x); };
            CHECK(says(ratio, text(n), text(n)) == "verified");
            CHECK(says(ratio, text(n + 1), text(n)) == "verified");  // it is true, and says less
            CHECK(says(ratio, text(n + 1), text(n + 1)) == "lower");
            CHECK(says(ratio, text(n - 1), text(n - 1)) == (n > 2 ? "upper" : "number"));
            if (n > 2) CHECK(says(ratio, text(n), text(n - 1)) == "verified");
        }
    }
    SECTION("next to a step two values are all that can be said") {
        for (const auto& [ratio, above] : std::vector<std::pair<std::string, std::uint64_t>>{
                 {"4572/1000", 4}, {"4799/1000", 4}, {"627/10", 9}, {"1032804/1", 902}, {"1035105/1", 903}}) {
            mpq_class q(ratio);
            q.canonicalize();
            const std::string exact = dumbbell_verify::to_string(q), n = std::to_string(above),
                              below = std::to_string(above - 1);
            INFO(exact);
            CHECK(says(exact, n, below) == "verified");
            CHECK(says(exact, n, n) == "lower");
            CHECK(says(exact, below, below) == "upper");
        }
        // At A and B themselves, and a little nearer to the step.
        CHECK(says("32/7", "3", "3") == "verified");
        CHECK(says("457143/100000", "3", "3") == "upper");
        CHECK(says("24/5", "4", "4") == "verified");
        CHECK(says("479999/100000", "4", "4") == "lower");
    }
    SECTION("ratios as great as one can write, to the last unit of N") {
        for (const std::size_t power : {100, 1000, 2098}) {
            const std::string ratio = ten_to(power) + "/1";
            mpz_class n = mpz_class(at_1e100);
            if (power > 100) {  // C to as many digits, by the prover's own rule
                dumbbell_verify::Big::precision = static_cast<mpfr_prec_t>(power * 34 / 10 + 100);
                const auto C = dumbbell_verify::growth_constant<dumbbell_verify::Big>();
                mpz_class scale;
                mpz_ui_pow_ui(scale.get_mpz_t(), 10, power / 2);
                const mpq_class place = exact_value(C.lo) * scale;
                n = place.get_num() / place.get_den() + 2;
            }
            const auto text = [](const mpz_class& x) { return x.get_str(); };
            INFO(power);
            CHECK(says(ratio, text(n), text(n)) == "verified");
            CHECK(says(ratio, text(n + 1), text(n + 1)) == "lower");
            CHECK(says(ratio, text(n - 1), text(n - 1)) == "upper");
        }
        CHECK(says(ten_to(2100) + "/1", "4", "4") == "number");
        CHECK(says(ten_to(1'000'000) + "/1", "4", "4") == "line");
        CHECK(says("10/1", "4" + std::string(2100, '0'), "4") == "number");
    }
    SECTION("beyond the last step the bounds of Theorem A decide, to the last bit") {
        for (const auto& [N, beyond, k] : edges) {
            INFO(N << " " << beyond);
            const mpz_class found = edge(N, beyond);
            CHECK(found.get_str() == k);
            const law_truth::Real q = law_truth::Real(found.get_str()) / pow(law_truth::Real(2), 220),
                                  root = sqrt(q), excess = law_truth::Real(law_truth::C) * root - (N - 2),
                                  rest = law_truth::Real(law_truth::c0) / sqrt(root);
            const law_truth::Real bound =
                beyond ? law_truth::Real("0.16") : law_truth::Real("0.063") * log(q) + law_truth::Real("0.7");
            CHECK(abs(excess - (rest - bound / root)) < 1e-57);
        }
    }
    SECTION("every field has one spelling, and belongs to the others") {
        for (const auto& [from, to, code] :
             {std::tuple{"claim collisions-by-law", "claim collisions-by-laws", "unsupported"},
              {"claim collisions-by-law", "claim collisions", "unsupported"},
              {"section none", "section turning", "unsupported"},
              {"scene dumbbell", "scene wedge", "unsupported"},
              {"ratio 10/1", "ratio 20/2", "number"},
              {"ratio 10/1", "ratio 1/10", "number"},
              {"ratio 10/1", "ratio 10/1 10/1", "syntax"},
              {"ratio 10/1", "ratio 12/1", "upper"},
              {"ratio 10/1", "ratio 4/1", "lower"},
              {"law 65bdaf", "law 65Bdaf", "number"},
              {"law 65bdaf", "law 65bda", "number"},
              {"law 65bdaf", "law 65bdae", "usage"},
              {"upper 4", "upper none", "number"},
              {"upper 4", "upper 04", "number"},
              {"upper 4", "upper 1", "number"},
              {"upper 4", "upper 3", "upper"},
              {"upper 4", "upper 6", "number"},
              {"lower 4", "lower 5", "number"},
              {"lower 4", "lower 2", "number"},
              {"lower 4\n", "lower 4\nlower 4\n", "syntax"},
              {"upper 4\nlower 4\n", "lower 4\nupper 4\n", "syntax"}}) {
            INFO(from << " -> " << to);
            CHECK(outcome_with_law(by_law_mutant(from, to)) == code);
        }
        CHECK(says("1/1", "2", "1") == "number");
        CHECK(make::failure(by_law_mutant("upper 4", "upper 1"), with_law()).line == 9);
        Settings settings = with_law();
        settings.demand.keep = true;
        CHECK(make::failure(by_law("10/1", "4", "4"), settings).line == 0);
        CHECK(outcome_with_law(by_law("10/1", "4", "4") + "x\n") == "trailing");
        CHECK(outcome_with_law(make::replaced(by_law("10/1", "4", "4"), "test 1.0", "test 1.1")) == "sha256");
        CHECK(outcome_with_law(by_law("10/1", "4", "4").substr(0, 100)) == "truncated");
    }
    SECTION("nothing is verified without the file that it names, verified itself") {
        const std::string text = by_law("10/1", "4", "4");
        CHECK(make::outcome(text) == "usage");
        const auto with = [&](const std::string& law, const std::string& digest, unsigned precision = 0,
                              unsigned max_bits = 2048) {
            Settings settings;
            settings.law = std::make_shared<LawFile>(law);
            settings.precision = precision;
            settings.max_bits = max_bits;
            const Failure failure = make::failure(by_law("10/1", "4", "4", digest), settings);
            CHECK(failure.line == 0);  // it is about no line of this file
            return std::pair(failure.verdict, failure.text);
        };
        const auto unreadable = [](const std::string& reason) {
            return std::pair(Verdict::unreadable, reason);
        };
        CHECK(with("/nowhere/law.dbc", law_digest) ==
              unreadable("--law /nowhere/law.dbc: No such file or directory"));
        CHECK(with(shipped_law, std::string(64, '0')) ==
              unreadable("--law " + shipped_law + " has sha256=" + law_digest +
                         ", and this file rests on the one with sha256=" + std::string(64, '0')));
        const std::string other = DUMBBELL_PROJECT "/certificates/q-10.dbc";
        CHECK(with(other, law_digest) == unreadable("--law " + other + ": is not a file of the claim law"));
        const make::File itself(text);
        CHECK(with(itself.path(), law_digest) ==
              unreadable("--law " + itself.path() + ": is not a file of the claim law"));
        const make::File full(
            make::hashed(make::replaced(make::law_steps(), "section turning", "section full")));
        CHECK(with(full.path(), law_digest) ==
              unreadable("--law " + full.path() + ": is not a file of the claim law"));
        const make::File precise(make::mutated_law("bits 53", "bits 64"));
        CHECK(with(precise.path(), law_digest, 0, 60).first == Verdict::limit);
        const make::File fine(make::law_that_doubles_do_not_decide());
        CHECK(make::has(with(fine.path(), law_digest).second, "not certified: C sqrt A - (N - 2) > 0"));
        CHECK(make::has(with(fine.path(), law_digest, 300).second, "expected step 10"));
        const make::File none("x\n");
        CHECK(with(none.path(), law_digest).second ==
              "--law " + none.path() + ": line 1: expected `dumbbell-certificate` with 1 value(s)");
        // A law that is false, but has the SHA-256 that is asked for: a cover at a ratio beyond the step.
        const std::string step = make::law_line("step 4 ");
        const std::string false_law = make::mutated_law(step, "step 4 19/4 24/5");
        const make::File forged(false_law);
        const auto [verdict, reason] = with(forged.path(), false_law.substr(false_law.size() - 65, 64));
        CHECK(verdict == Verdict::rejected);
        INFO(reason);
        CHECK(reason.starts_with("--law " + forged.path() + ": line "));
    }
}

TEST_CASE("by law: of one ratio no other is proved, and no better bounds") {
    const LawAtRatio claim{10, 4, 5, ""};
    const auto missing = [&](const mpq_class& lo, const mpq_class& hi) {
        Collisions demand;
        demand.ratios = {lo, hi};
        return claim.missing(demand);
    };
    CHECK(missing(10, 10).empty());
    CHECK(missing(9, 10) == "of the mass ratios 9/1:10/1 only 10/1:10/1 are covered");
    CHECK(missing(10, 11) == "of the mass ratios 10/1:11/1 only 10/1:10/1 are covered");
    CHECK(missing(11, 12) == "nothing is said of the mass ratios 11/1:12/1, only of 10/1:10/1");
    const auto bounds = [&](std::optional<mpz_class> least, std::optional<mpz_class> most) {
        Collisions demand;
        demand.least = std::move(least);
        demand.most = std::move(most);
        return claim.missing(demand);
    };
    CHECK(bounds(4, 5).empty());
    CHECK(bounds(3, 6).empty());
    CHECK(bounds(5, {}) == "not proved: at least 5 collisions at the mass ratio 10/1");
    CHECK(bounds({}, 4) == "not proved: at most 4 collisions at the mass ratio 10/1");
    CHECK(bounds({}, {}).empty());
}

TEST_CASE("by law: verdict, exit code, JSON and demands, as a script sees them") {
    const std::string text = by_law(ten_to(100) + "/1", at_1e100, at_1e100),
                      law = "--law " + shipped_law + " ";
    const make::File file(text), open(by_law("627/10", "9", "8")), wrong(by_law("10/1", "5", "5"));
    const make::Run verified = run(law + "--ratio 1e100 --exactly " + at_1e100 + " " + file.path());
    CHECK(verified.code == 0);
    CHECK(verified.last() == "s VERIFIED claim=collisions-by-law ratio=" + ten_to(100) +
                                 "/1 upper=" + at_1e100 + " lower=" + at_1e100 + " law=" + law_digest +
                                 " sha256=" + text.substr(text.size() - 65, 64));
    CHECK(verified.out.find("  This rests on the law for every mass ratio (proofs/law.md), ") !=
          std::string::npos);
    if (make::sanitized) return;  // each run below verifies the law: a minute
    // Five claims, the law verified once.
    const std::string of_open = open.path() + "\t--ratio 62.7 ";
    const make::File list(of_open + "--claim collisions-by-law --max 9 --min 8\n" + of_open +
                          "--exactly 9\n" + open.path() + "\t--ratio 62 --max 9\n" + of_open +
                          "--claim collisions --max 9\n" + wrong.path() + "\t--ratio 10 --max 5\n");
    const make::Run several = run(law + "--budget 10s --json --claims " + list.path());
    CHECK(several.code == 1);
    const auto times = [&](const std::string& part) {
        int n = 0;
        for (std::size_t at = several.out.find(part); at != std::string::npos;
             at = several.out.find(part, at + 1))
            ++n;
        return n;
    };
    CHECK(times("\"verdict\":\"VERIFIED\"") == 1);
    CHECK(times("\"code\":\"claim-not-proved\"") == 3);
    CHECK(times("\"code\":\"lower\"") == 1);
    CHECK(times("\"claim\":{\"kind\":\"collisions-by-law\",\"ratio\":{\"lo\":\"627/10\",\"hi\":\"627/10\"},"
                "\"upper\":9,\"lower\":8,\"law\":\"" +
                law_digest + "\"}") == 1);
    CHECK(run(law + "--explain lower " + open.path()).out.find("  the step to 8 is in 45/1:46/1\n") !=
          std::string::npos);
    CHECK(run(law + "--explain upper " + file.path())
              .out.starts_with("upper, line 9: upper " + at_1e100 +
                               "\n  C sqrt q - (N - 2) in [-0.79165927391944224, -0.79165927391944213]\n"
                               "  c0 q^(-1/4) less its bounds by Theorem A in [2.0581158954949557e-26, "
                               "2.058115895494956e-26]\n  certified\n"));
    const make::Run bare = run(open.path());
    CHECK(bare.code == 2);
    CHECK(bare.last() == "s UNREADABLE line=8 this file rests on the certificate of the law with sha256=" +
                             law_digest + ": give it by --law FILE");
    CHECK(run(law + "--budget 0.5s " + open.path()).code == 4);
    CHECK(run(law + law + open.path()).err == "dumbbell-verify: --law is given twice\n");
    for (const auto& demand : {std::string("--together "), "--lemma 4.1 " + open.path() + " "})
        CHECK(run(law + demand + open.path()).code == 2);
}
