#include "verify/program/together.hpp"

#include <algorithm>
#include <tuple>

#include "verify/core/section.hpp"
#include "verify/program/escape.hpp"

namespace dumbbell_verify {
namespace {

bool goes_before(const Result* a, const Result* b) {
    const Collisions &p = a->proof.claim, &q = b->proof.claim;
    return std::tie(p.lo, p.hi) < std::tie(q.lo, q.hi);
}

Failure rejected(std::string code, std::string text) {
    return {Verdict::rejected, 0, std::move(code), std::move(text)};
}

/// Of a file that does not begin where the one before ended.
Failure broken_chain(const Result& before, const Result& next) {
    const mpq_class &end = before.proof.claim.hi, &begin = next.proof.claim.lo;
    return rejected("chain", (begin > end ? "a hole: " : "an overlap: ") + one_line(before.job->file) +
                                 " ends at " + to_string(end) + ", and " + one_line(next.job->file) +
                                 " begins at " + to_string(begin));
}

std::string scene_of(const Result& file) {
    const auto& rho = file.proof.claim.rho;
    return one_line(file.job->file) + " is about the scene " + std::string(file.proof.section->scene) +
           (rho ? " with rho in " + to_string(rho->first, rho->second) : "");
}

/// The same, of this file among others.
Failure named(const Result& bad) {
    Failure why = bad.why;
    why.text = one_line(bad.job->file) + ": " +
               (why.line > 0 ? "line " + std::to_string(why.line) + ": " : "") + why.text;
    why.line = 0;
    return why;
}

}  // namespace

void append(Collisions& all, const Collisions& next) {
    for (std::size_t i = 0; i < next.reached.size(); ++i)
        if (next.reached[i] && all.reached[i].value_or(all.start()) >= all.hi)
            all.reached[i] = next.reached[i];
    all.hi = next.hi;
    all.join(next);
    all.ask(next.asked);
    all.known.join(next.known);
}

Result together(const Job& asked, const std::vector<Result>& files) {
    Result whole;
    whole.job = &asked;
    std::vector<const Result*> chain;
    for (const Result& file : files) {
        if (file.why.verdict > whole.why.verdict) whole.why = named(file);
        chain.push_back(&file);
    }
    if (whole.why.verdict != Verdict::verified) return whole;
    std::sort(chain.begin(), chain.end(), goes_before);
    Collisions& claim = whole.proof.claim = chain.front()->proof.claim;
    whole.proof.heavy_once = true;
    whole.proof.section = chain.front()->proof.section;
    for (std::size_t i = 0; i < chain.size(); ++i) {
        const Proof& next = chain[i]->proof;
        whole.proof.heavy_once = whole.proof.heavy_once && next.heavy_once;
        if (i == 0) continue;
        if (next.section->scene != whole.proof.section->scene || next.claim.rho != claim.rho) {
            whole.why =
                rejected("chain", "several scenes: " + scene_of(*chain[0]) + ", " + scene_of(*chain[i]));
            return whole;
        }
        if (next.claim.lo != claim.hi) {
            whole.why = broken_chain(*chain[i - 1], *chain[i]);
            return whole;
        }
        append(claim, next.claim);
    }
    if (const std::string gap = claim.missing(); !gap.empty())
        whole.why = rejected("claim-not-proved", gap);
    else if (claim.says_nothing())
        whole.why = nothing_proved();
    return whole;
}

}  // namespace dumbbell_verify
