#include "verify/wings/adiabatic/demand.hpp"

#include "verify/machine/integer.hpp"

namespace dumbbell_verify::adiabatic {

std::string missing(const Claim& claim, const Numbers& numbers) {
    const auto asked = [&](std::string_view name, const mpq_class& lo, const mpq_class& hi) {
        const auto given = numbers.find(name);
        return given == numbers.end() ? Range(lo, hi) : given->second;
    };
    const auto only = [](const std::string& asked_for, const std::string& proved) {
        return "not proved: " + asked_for + ", only " + proved;
    };
    const Range of_file(claim.y_lo, claim.y_hi), heights = asked("heights", claim.y_lo, claim.y_hi),
                                                 delta = asked("delta", claim.delta_lo, claim.delta_hi);
    // At 0 no file says anything.
    if (delta.first < claim.delta_lo || delta.second > claim.delta_hi || delta.second == 0)
        return only("delta=" + to_string(delta.first, delta.second),
                    to_string(claim.delta_lo, claim.delta_hi));
    if (heights.first < claim.y_lo || heights.second > claim.y_hi)
        return only("heights=" + to_string(heights.first, heights.second), to_string(claim.y_lo, claim.y_hi));
    const mpq_class margin = asked("margin", claim.margin, claim.margin).first;
    if (margin < claim.margin) return only("margin=" + to_string(margin), to_string(claim.margin));
    mpq_class k(integer(claim.exponent), 16);
    k.canonicalize();
    if (const mpq_class exponent = asked("exponent", k, k).first; exponent != k)
        return only("exponent=" + to_string(exponent), to_string(k));
    for (std::size_t i = 0; i < claim.bounds.size(); ++i) {
        const auto number = i == 0 ? &Range::first : &Range::second;
        const Claim::Attained& state = claim.attained.at(i);
        const mpq_class &bound = claim.bounds[i], most = asked("constant", bound, bound).*number,
                        least = asked("attained", state.value, state.value).*number;
        if (bound > most) return only("constant=" + to_string(most), to_string(bound));
        if (state.value < least) return only("attained=" + to_string(least), to_string(state.value));
        const bool is_asked_for = state.delta >= delta.first && state.delta <= delta.second &&
                                  heights == of_file && margin == claim.margin;
        if (numbers.contains("attained") && !is_asked_for)
            return only("attained with the delta, heights and margin demanded", "with those of the file");
    }
    return "";
}

}  // namespace dumbbell_verify::adiabatic
