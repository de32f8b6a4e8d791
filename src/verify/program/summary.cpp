#include "verify/program/summary.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

#include "verify/core/section.hpp"
#include "verify/machine/decimals.hpp"
#include "verify/program/claim_options.hpp"
#include "verify/program/escape.hpp"
#include "verify/program/number_options.hpp"
#include "verify/program/sentence.hpp"

namespace dumbbell_verify {

std::string three_digits(mpq_class x) {
    if (x == 0) return "0";
    int exponent = 0;
    for (; x >= 10; x /= 10) ++exponent;
    for (; x < 1; x *= 10) --exponent;
    mpz_class digits;
    mpz_cdiv_q(digits.get_mpz_t(), mpz_class(x.get_num() * 100).get_mpz_t(), x.get_den_mpz_t());
    if (digits == 1000) digits = 100, ++exponent;
    return digits.get_str().insert(1, ".") + "e" + std::to_string(exponent);
}

std::string claim_text(const Verified& proof) {
    if (proof.other) return proof.other->text();
    const Collisions& claim = proof.claim;
    const auto [from, to] = claim.question();
    return "scene=" + std::string(proof.section->scene) + " ratio=" + to_string(claim.lo, claim.hi) +
           (claim.rho ? " rho=" + to_string(claim.rho->first, claim.rho->second) : "") +
           " upper=" + (claim.upper ? claim.upper->get_str() : "none") + " lower=" + claim.lower.get_str() +
           " gaps=" + std::to_string(claim.gaps) + " open=" + std::to_string(claim.open) +
           (from < to ? " widest-gap=" + three_digits(claim.whole().widest) : "") +
           (proof.decided ? " decided=" + decimals(*proof.decided, false) : "") +
           (proof.heavy_once ? " heavy-at-most=1" : "");
}

std::string left_out(const Result& result) {
    const std::string names = not_demanded(result.proof, result.job->settings, ",");
    return names.empty() ? "" : " not-demanded=" + names;
}

std::string result_text(const Result& result) {
    const Failure& why = result.why;
    const Request& settings = result.job->settings;
    if (result.is_right())
        return claim_text(result.proof) + " sha256=" + result.proof.digest + demand_text(settings) +
               left_out(result);
    std::string text;
    if (why.line > 0) text = "line=" + std::to_string(why.line) + " ";
    if (why.verdict == Verdict::rejected) text += "code=" + why.code + " ";
    return text + one_line(why.text);
}

std::string verdict_line(const Result& result) {
    return std::string("s ") + verdict_name(result.why.verdict) + " " + result_text(result);
}

std::string block(const Result& result, bool leaves) {
    std::string text = leading_name(result.job->file) + "\n";
    if (result.is_right()) text += sentence(result);
    for (const Tally& tally : leaves&& result.is_right() ? result.proof.tallies : std::vector<Tally>()) {
        std::array<char, 100> line{};
        std::snprintf(line.data(), line.size(), "  %-15s%12s line(s)%11.5f %% of the root boxes\n",
                      std::string(tally.name).c_str(), std::to_string(tally.lines).c_str(),
                      100 * tally.covered / std::max(1.0, result.proof.roots));
        text += line.data();
    }
    return text + verdict_line(result) + "\n";
}

std::string summary_line(const std::vector<Result>& results) {
    const auto count = [&](Verdict verdict) {
        const auto n = std::count_if(results.begin(), results.end(),
                                     [&](const Result& r) { return r.why.verdict == verdict; });
        return std::to_string(n);
    };
    std::uint64_t open = 0;
    for (const Result& result : results) open += result.is_right() ? result.proof.claim.open : 0;
    return "c files=" + std::to_string(results.size()) + " verified=" + count(Verdict::verified) +
           " rejected=" + count(Verdict::rejected) + " limit=" + count(Verdict::limit) +
           " unsupported=" + count(Verdict::unsupported) + " unreadable=" + count(Verdict::unreadable) +
           " nothing-proved=" + count(Verdict::open) + " open=" + std::to_string(open) +
           " exit=" + std::to_string(exit_code(worst(results)));
}

Verdict worst(const std::vector<Result>& results) {
    Verdict verdict = Verdict::verified;
    for (const Result& result : results) verdict = std::max(verdict, result.why.verdict);
    return verdict;
}

}  // namespace dumbbell_verify
