#include "verify/program/sentence.hpp"

#include "verify/core/section.hpp"
#include "verify/machine/decimals.hpp"
#include "verify/program/number_options.hpp"
#include "verify/program/summary.hpp"

namespace dumbbell_verify {
namespace {

struct Phrases {
    std::string hits, hits_it;  ///< `no ... more than 4 times`, `and some ... 4 times`
};
Phrases phrases_of(std::string_view scene) {
    if (scene == "dumbbell") return {"trajectory hits the floor", "trajectory hits it"};
    return {"motion of the body in a plane, without a corner, hits the floor", "motion hits it"};
}

std::string times(const mpz_class& n) { return n.get_str() + (n == 1 ? " time" : " times"); }

/// As a decimal if it is a short one, else P/Q.
std::string spoken(const mpq_class& q) {
    constexpr unsigned longest = 30;
    mpz_class power = 1;
    unsigned places = 0;
    for (; power % q.get_den() != 0 && places < longest; ++places) power *= 10;
    return power % q.get_den() != 0 ? to_string(q) : decimals(q, false, places);
}

/// How much is known, where the bounds together do not tell it.
std::string known(const Collisions& claim) {
    const Bounds& all = claim.asked;
    if (all.pieces < 2 || (all.upper && *all.upper == all.lower)) return "";
    const auto count = [](std::uint64_t n) { return std::to_string(n); };
    return "; the greatest number is known in " + count(all.pieces - all.gaps - all.open) + " of " +
           count(all.pieces) + " pieces" +
           (all.gaps > 0 ? std::string(", one of two ") + (all.leap > 1 ? "or three " : "") +
                               "neighbouring values in " + count(all.gaps)
                         : "") +
           (all.open > 0 ? ", open in " + count(all.open) : "") +
           "; the stretches where it is not known have a "
           "relative width of at most " +
           three_digits(claim.whole().widest);
}

/// `no ... and some ...`, as far as there are bounds.
std::string bounded(const Bounds& all, const Phrases& say) {
    std::string text;
    if (all.upper) text = "no " + say.hits + " more than " + times(*all.upper);
    if (all.lower > 0)
        text += (all.upper ? ", and some " + say.hits_it : "some " + say.hits) +
                (all.upper == all.lower ? " " : " at least ") + times(all.lower);
    return text;
}

std::string about_collisions(const Result& result) {
    const Collisions& claim = result.proof.claim;
    Bounds all = claim.asked;
    if (claim.most || (claim.least && *claim.least > 0)) {  // what was demanded, and no more
        all = Bounds(claim.most, claim.least.value_or(0));
    }
    const mpq_class &from = claim.ratios ? claim.ratios->first : claim.lo,
                    &to = claim.ratios ? claim.ratios->second : claim.hi;
    const auto every = [](const std::string& name, const mpq_class& lo, const mpq_class& hi) {
        return lo == hi ? "at " + name + " " + spoken(lo)
                        : "at every " + name + " from " + spoken(lo) + " to " + spoken(hi);
    };
    std::string where = every(claim.rho ? "Q" : "mass ratio", from, to);
    if (const auto& rhos = claim.rhos ? claim.rhos : claim.rho)
        where += ", " + every("rho", rhos->first, rhos->second);
    const Phrases phrases = phrases_of(result.proof.section->scene);
    const std::string bounds = bounded(all, phrases);
    if (const auto& share = result.proof.decided; share && *share < 1 && (*share > 0 || bounds.empty()))
        return "Proved: of at least " + decimals(*share, false) + " of the bodies with Q rho > 1, " + where +
               ", by area in (log rho, log Q), the greatest number of times that a " + phrases.hits +
               (bounds.empty() ? "" : "; and of all of them, " + bounds);
    return (bounds.empty() ? "No bound is proved that holds " + where
                           : "Proved: " + where + (claim.rho ? ", " : " ") + bounds) +
           known(claim) +
           (result.proof.heavy_once ? "; in every trajectory the heavy mass hits the floor at most once"
                                    : "");
}

}  // namespace

std::string sentence(const Result& result) {
    const std::string names = not_demanded(result.proof, result.job->settings, ", "),
                      rest = names.empty() ? "" : "  Not demanded: " + names + ".\n";
    if (result.proof.other) return result.proof.other->paragraph() + rest;
    return "  " + about_collisions(result) + ".\n" + rest;
}

}  // namespace dumbbell_verify
