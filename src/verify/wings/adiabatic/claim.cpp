#include "verify/wings/adiabatic/claim.hpp"

#include "verify/machine/decimals.hpp"

namespace dumbbell_verify::adiabatic {
namespace {

std::string pair(const mpq_class& lo, const mpq_class& hi) {
    return "{\"lo\":\"" + to_string(lo) + "\",\"hi\":\"" + to_string(hi) + "\"}";
}
std::string list(const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : ",") + part;
    return "[" + text + "]";
}
std::string quoted(const std::string& text) { return "\"" + text + "\""; }

/// About a number of a file, which may have many digits.
std::string about(const mpq_class& x) {
    const std::string exact = to_string(x);
    return exact.size() <= 20 ? exact : "about " + decimals(x, false, 9);
}
std::string range(const mpq_class& lo, const mpq_class& hi) {
    return lo == hi ? "= " + about(lo) : "in [" + about(lo) + ", " + about(hi) + "]";
}
/// `For every delta in ...`, of which 0 is none.
std::string deltas(const mpq_class& lo, const mpq_class& hi) {
    return lo == hi ? "For delta = " + about(lo)
                    : "For every delta in " + (lo == 0 ? "(0" : "[" + about(lo)) + ", " + about(hi) + "]";
}
std::string power(std::uint64_t sixteenths) {
    const mpq_class exponent = mpq_class(mpz_class(std::to_string(sixteenths))) / 16;
    if (exponent == 0) return "";
    if (exponent == 1) return " delta";
    return " delta^" +
           (exponent.get_den() == 1 ? exponent.get_num().get_str() : "(" + to_string(exponent) + ")");
}

/// `number` tells C1 and B1 from C2 and B2.
std::string state_text(const Claim::Attained& state, const Claim::Summary& value, const std::string& number) {
    const std::string C = "C" + number, B = "B" + number;
    return "  Certified for u = " + about(state.u) + ", ydot = -delta s, s = " + about(state.s) +
           ", delta = " + about(state.delta) + ", with " + std::to_string(state.collisions) +
           " collision(s) more:\n  the same with " + B + " = " + value.attained + " and >= instead of " + C +
           " and <=" + (value.ratio.empty() ? ".\n" : "; " + C + "/" + B + " <= " + value.ratio + ".\n");
}
std::string state_json(const Claim::Attained& state, const std::string& ratio) {
    return "{\"u\":\"" + to_string(state.u) + "\",\"s\":\"" + to_string(state.s) + "\",\"delta\":\"" +
           to_string(state.delta) + "\",\"collisions\":" + std::to_string(state.collisions) +
           ",\"value\":\"" + to_string(state.value) +
           "\",\"ratio\":" + (ratio.empty() ? "null" : quoted(ratio)) + "}";
}

}  // namespace

std::vector<Claim::Summary> Claim::summaries() const {
    std::vector<Summary> all;
    for (std::size_t i = 0; i < attained.size(); ++i) {
        const mpq_class& value = attained[i].value;
        Summary summary;
        summary.attained = decimals(value, false);
        summary.bound = decimals(bounds.at(i), true);
        if (value > 0) summary.ratio = decimals(bounds[i] / value, true);
        all.push_back(summary);
    }
    return all;
}

std::string Claim::text() const {
    std::string result = "claim=" + std::string(kind_name()) + " delta=" + to_string(delta_lo, delta_hi);
    if (has_heights()) result += " heights=" + to_string(y_lo, y_hi);
    result += " margin=" + to_string(margin);
    if (kind == bounce) result += " exponent=" + std::to_string(exponent) + "/16";
    const auto all = summaries();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string number = all.size() > 1 ? std::to_string(i + 1) : "";
        result += " C" + number + "=" + all[i].bound + " B" + number + "=" + all[i].attained;
        if (delta_lo < delta_hi) result += " at" + number + "=" + to_string(attained[i].delta);
        if (!all[i].ratio.empty()) result += " ratio" + number + "=" + all[i].ratio;
    }
    return result;
}

std::string Claim::paragraph() const {
    const std::string heights = "heights y " + range(y_lo, y_hi), size = about(margin);
    const auto all = summaries();
    std::string text = "  " + deltas(delta_lo, delta_hi) +
                       ", beta1 = epsilon = delta^2, and a collision of the light mass at which\n"
                       "  |phidot| = 1 and ydot is in [-delta, 0] before it,\n";
    switch (kind) {
        case bounce:
            text += "  " + heights + ", the rod at least " + size + power(exponent) +
                    " from the vertical, and the light mass collides next:\n"
                    "  | |phidot+| - |phidot-| + 2 ydot-/sqrt(1 - y^2) | <= C1" +
                    power(32 - 2 * exponent) + ", C1 = " + all[0].bound +
                    ",\n  | y+ - y - 2 (pi - arccos y) ydot-/|phidot-| | <= 2 C2" + power(32 - exponent) +
                    ", C2 = " + all[1].bound + ".\n";
            break;
        case run:
            text += "  " + heights + ": as long as only the light mass collides, and with the rod at least " +
                    size +
                    " from the vertical,\n  |I_n - I_0| <= C delta for every number n of further collisions, "
                    "C = " +
                    all[0].bound + "; I = |phidot| (pi - arccos y) before a collision.\n";
            break;
        case scattering:
            text += "  the first of a regular trajectory and at u >= " + size +
                    " delta^(1/2), u the rod's distance from the vertical:\n"
                    "  if the last collision is at u >= " +
                    size + " delta^(1/2), too, then |I_N - I_0| <= C delta^(1/2), C = " + all[0].bound +
                    ",\n  I = |phidot| (pi - arccos y) before the first and after the last collision; the "
                    "heavy mass does not collide.\n";
            break;
    }
    for (std::size_t i = 0; i < attained.size(); ++i)
        text += state_text(attained[i], all[i], attained.size() > 1 ? std::to_string(i + 1) : "");
    return text;
}

std::string Claim::json() const {
    std::vector<std::string> constants, states;
    for (const mpq_class& bound : bounds) constants.push_back(quoted(to_string(bound)));
    const auto all = summaries();
    for (std::size_t i = 0; i < attained.size(); ++i) states.push_back(state_json(attained[i], all[i].ratio));
    return "{\"kind\":\"" + std::string(kind_name()) + "\",\"delta\":" + pair(delta_lo, delta_hi) +
           ",\"heights\":" + (has_heights() ? pair(y_lo, y_hi) : "null") + ",\"margin\":\"" +
           to_string(margin) + "\",\"exponent\":" + (kind == bounce ? std::to_string(exponent) : "null") +
           ",\"bounds\":" + list(constants) + ",\"attained\":" + list(states) + "}";
}

}  // namespace dumbbell_verify::adiabatic
