#include "adiabatic/report.hpp"

#include <fmt/core.h>

#include "adiabatic/writer.hpp"
#include "base/printable.hpp"
#include "number/decimal.hpp"
#include "words/printed.hpp"
#include "words/text_table.hpp"

namespace dumbbell::adiabatic {
namespace {

constexpr int shown_digits =
    7;  ///< of an initial condition, for people; the exact one is in the certificate and in --json

/// 0 is no delta.
std::string delta_text(const Hypotheses& of) {
    const auto& [lo, hi] = of.delta;
    return lo == hi ? fmt::format("delta = {}", spelled(lo))
                    : fmt::format("every delta in {}{}, {}]", lo == 0 ? '(' : '[', spelled(lo), spelled(hi));
}

/// delta^(sixteenths/16); empty if that is 1.
std::string power(int sixteenths) {
    const Rational exponent(sixteenths, 16);
    return sixteenths == 0              ? ""
           : sixteenths == 16           ? "delta"
           : denominator(exponent) == 1 ? fmt::format("delta^{}", exact_text(exponent))
                                        : fmt::format("delta^({})", to_fraction(exponent));
}

std::string margin_text(const Hypotheses& of) {
    const std::string factor = of.margin == 1 ? "" : spelled(of.margin) + " ";
    switch (of.claim) {
        case Claim::bounce:
            return of.exponent == 0 ? spelled(of.margin) : factor + power(of.exponent);
        case Claim::run:
            return spelled(of.margin);
        default:
            return factor + "sqrt(delta)";
    }
}

/// What the errors are called, and the units of the bounds.
struct Unit {
    const char* error;
    std::string unit;
};

std::vector<Unit> units(const Hypotheses& of) {
    switch (of.claim) {
        case Claim::bounce:
            return {{"||phidot_+| - |phidot_-| + 2 ydot_-/sqrt(1 - y^2)|", power(32 - 2 * of.exponent)},
                    {"|y_+ - y - 2 (pi - arccos y) ydot_-/|phidot_-||", "* 2 " + power(32 - of.exponent)}};
        case Claim::run:
            return {{"|I_n - I_0|", "delta"}};
        default:
            return {{"|I_N - I_0|", "sqrt(delta)"}};
    }
}

std::string hypotheses_text(const Hypotheses& of) {
    const std::string delta = delta_text(of);
    const std::string margin = margin_text(of);
    const std::string states = fmt::format(
        "For {}, epsilon = delta^2 the light mass's share, I = |phidot| (pi - arccos y),\n"
        "and every state with |phidot| = 1 and -delta <= ydot <= 0 just before",
        delta);
    const std::string heights =
        fmt::format("at a height y from {} to {},", spelled(of.heights.first), spelled(of.heights.second));
    switch (of.claim) {
        case Claim::bounce:
            return fmt::format(
                "{} a collision of the light mass {}\n"
                "at distance |phi - 3 pi/2| >= {} from the vertical, "
                "whose next collision is one of the light mass too:",
                states, heights, margin);
        case Claim::run:
            return fmt::format(
                "{} collision 0 {}\n"
                "for any number n of bounces of the light mass with no collision of the heavy mass between, "
                "all at distance\n"
                "|phi - 3 pi/2| >= {} from the vertical:",
                states, heights, margin);
        default:
            return fmt::format(
                "{} the first collision of a whole scattering,\n"
                "if the first and the last collision are at distance |phi - 3 pi/2| >= {} from the vertical:",
                states, margin);
    }
}

std::string state_text(const State& state) {
    const std::string u = to_decimal(state.u, shown_digits), s = to_decimal(state.s, shown_digits);
    const std::string ydot =
        state.s == 0 ? "= 0" : fmt::format("{} -{} delta", parse_rational(s) == state.s ? "=" : "about", s);
    return fmt::format("delta = {}, distance {}{} from the vertical, ydot {}, n = {}", spelled(state.delta),
                       parse_rational(u) == state.u ? "" : "about ", u, ydot, state.n);
}

/// C/B, rounded up.
std::string ratio_text(const Rational& bound, const State& state) {
    return rounded_up(enclose<Interval>(bound / state.value).hi());
}

std::string unit_text(const Unit& unit) { return unit.unit.empty() ? "" : " " + unit.unit; }

std::string bound_text(const Proof& proof, std::size_t i) {
    const Unit unit = units(proof.hypotheses)[i];
    return i < proof.bounds.size()
               ? fmt::format("{} <= {}{}", unit.error, spelled(proof.bounds[i]), unit_text(unit))
               : fmt::format("{}: no bound was certified", unit.error);
}

std::string error_text(const Proof& proof, std::size_t i) {
    const std::string in = unit_text(units(proof.hypotheses)[i]);
    std::string text = "  " + bound_text(proof, i) + '\n';
    if (i < proof.attained.size()) {
        text += fmt::format("    attained: at least {}{} ({})\n", spelled(proof.attained[i].value), in,
                            state_text(proof.attained[i]));
        if (i < proof.bounds.size()) {
            text +=
                fmt::format("    upper/lower at most {}\n", ratio_text(proof.bounds[i], proof.attained[i]));
        }
    }
    return text;
}

std::string result_text(const Report& report, const Result& result) {
    const Proof& proof = result.proof;
    std::string text = hypotheses_text(proof.hypotheses) + '\n';
    for (std::size_t i = 0; i < units(proof.hypotheses).size(); ++i) {
        text += error_text(proof, i);
    }
    if (proof.hypotheses.claim == Claim::scattering && proof.complete()) {
        text += "  and the heavy mass is not touched.\n";
    }
    if (proof.coarser) {
        text += fmt::format(
            "The bound is proved; it exceeds what is attained by more than the relative accuracy {} that "
            "was aimed at (--accuracy).\n",
            spelled(report.accuracy));
    }
    return text + fmt::format("{} boxes, {:.1f} s\n", proof.leaves, result.seconds);
}

std::string table_text(const Report& report) {
    std::vector<TableLine> lines{{"distance", "error", "bound", "attained", "ratio", "boxes", "seconds"}};
    for (const Result& result : report.results) {
        const Proof& proof = result.proof;
        const auto names = units(proof.hypotheses);
        for (std::size_t i = 0; i < names.size(); ++i) {
            const bool bounded = i < proof.bounds.size(), found = i < proof.attained.size();
            const std::string unit = unit_text(names[i]);
            lines.push_back({margin_text(proof.hypotheses), names[i].error,
                             bounded ? spelled(proof.bounds[i]) + unit : "-",
                             found ? spelled(proof.attained[i].value) + unit : "-",
                             bounded && found ? ratio_text(proof.bounds[i], proof.attained[i]) : "-",
                             fmt::format("{}", proof.leaves), fmt::format("{:.1f}", result.seconds)});
        }
    }
    return aligned(lines, 1);
}

Json state_json(const State& state) {
    return Json::object({{"u", to_fraction(state.u)},
                         {"s", to_fraction(state.s)},
                         {"delta", to_fraction(state.delta)},
                         {"n", state.n},
                         {"value", to_fraction(state.value)}});
}

Json error_json(const Proof& proof, const Unit& unit, std::size_t i) {
    const bool bounded = i < proof.bounds.size(), found = i < proof.attained.size();
    return Json::object(
        {{"error", unit.error},
         {"unit", unit.unit.empty() ? "1" : unit.unit},
         {"bound", bounded ? Json(to_fraction(proof.bounds[i])) : Json()},
         {"attained", found ? state_json(proof.attained[i]) : Json()},
         {"ratio", bounded && found ? Json(enclose<Interval>(proof.bounds[i] / proof.attained[i].value).hi())
                                    : Json()}});
}

Json range_json(const std::pair<Rational, Rational>& range) {
    return Json::object({{"lo", to_fraction(range.first)}, {"hi", to_fraction(range.second)}});
}

Json result_json(const Result& result) {
    const Proof& proof = result.proof;
    const Hypotheses& of = proof.hypotheses;
    const bool has_heights = of.claim == Claim::bounce || of.claim == Claim::run;
    Json errors = Json::array();
    const auto names = units(of);
    for (std::size_t i = 0; i < names.size(); ++i) {
        errors.add(error_json(proof, names[i], i));
    }
    return Json::object(
        {{"claim", name(of.claim)},
         {"delta", range_json(of.delta)},
         {"y", has_heights ? range_json(of.heights) : Json()},
         {"margin", to_fraction(of.margin)},
         {"k", of.claim == Claim::bounce ? Json(to_fraction(Rational(of.exponent, 16))) : Json()},
         {"errors", errors},
         {"leaves", proof.leaves},
         {"accurate", !proof.coarser},
         {"seconds", result.seconds}});
}

}  // namespace

std::string verdict(const Report& report) {
    std::string text;
    for (const Result& result : report.results) {
        const Proof& proof = result.proof;
        for (std::size_t i = 0; i < units(proof.hypotheses).size(); ++i) {
            text += fmt::format("{}, distance {}: {}\n", delta_text(proof.hypotheses),
                                margin_text(proof.hypotheses), bound_text(proof, i));
        }
    }
    return text;
}

std::string to_text(const Report& report) {
    std::string text;
    if (report.results.size() == 1) {
        text = result_text(report, report.results.front());
    } else {
        std::string sentence = hypotheses_text(report.results.front().proof.hypotheses);
        text = sentence + "\n(and the same for the other distances)\n" + table_text(report);
    }
    if (report.out) {
        const Proof& proof = report.results.front().proof;
        text += fmt::format("Certificate: {} (sha256 {})\nCheck it:    dumbbell verify {} {}\n",
                            one_line(*report.out), *report.sha256,
                            claim_options(proof.hypotheses, proof.bounds, proof.attained),
                            shell_file(*report.out));
    }
    return text;
}

Json to_json(const Report& report) {
    Json results = Json::array();
    for (const Result& result : report.results) {
        results.add(result_json(result));
    }
    return Json::object({{"schema", "dumbbell-adiabatic-1"},
                         {"theorem", report.theorem},
                         {"accuracy", to_fraction(report.accuracy)},
                         {"results", results},
                         {"out", report.out},
                         {"sha256", report.sha256}});
}

}  // namespace dumbbell::adiabatic
