#include "critical/report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "collisions/step_guess.hpp"
#include "flight/extremal_orbit.hpp"
#include "flight/macro/when.hpp"
#include "number/decimal.hpp"
#include "words/printed.hpp"
#include "words/text_table.hpp"

namespace dumbbell::critical {
namespace {

/// A critical ratio as it is printed: its first digits, cut off, each of which is a digit of q_c, and a bound
/// of the distance from the number as printed to q_c. So neither depends on how much narrower the proved
/// enclosure is.
struct Number {
    std::string value;
    std::string radius;
    bool exact;
};

/// With `digits` significant digits. Throws BrokenInvariant if the enclosure does not decide them.
Number shown_number(const Ratio& ratio, int digits) {
    constexpr int radius_digits = 2;
    const auto shared = shared_digits(ratio.q_lo, ratio.q_hi, digits);
    require(shared.has_value(), "a critical ratio without the digits that were asked for");
    const Rational value = exact(*shared);  // at most q_lo
    const bool is_exact = value == ratio.q_hi;
    return {to_text(is_exact ? without_zeros(*shared) : *shared),
            to_text(cut_up(ratio.q_hi - value, radius_digits)), is_exact};
}

/// The orbit whose flight is tangent at q_c(n): `top` or `corner`.
const char* orbit_name(long n) {
    return flight::tangent_flight(n).orbit == flight::ExtremalOrbit::top ? "top" : "corner";
}

bool has_ratio(const Row& row) { return row.ratio.has_value(); }
bool is_of_rods(const Report& report) { return report.request.bodies && report.request.bodies->have_rods; }

/// The N of the first row that was left out.
std::optional<long> first_unreached(const Report& report) {
    const bool all = is_of_rods(report) || report.rows.back().n == report.request.last;
    return all ? std::nullopt : std::optional(report.rows.back().n + 1);
}

/// What the number is, in terms of the orbit, and what makes it the critical ratio.
std::string foundation(const std::string& flight) {
    return fmt::format(
        "By interval Newton it is the only ratio near it at which {} just touches\n"
        "the floor; that the maximum steps there is theorem 2 of proofs/theorem.md, which the covers of\n"
        "dumbbell certify do not use.\n",
        flight);
}
std::string long_foundation(const std::string& beginning, const std::string& flight) {
    return beginning + fmt::format(
                           "ust below it {} does not hit the floor, just above it does: the orbit was\n"
                           "followed by macro steps (L42). That the maximum steps there is theorem 2 of "
                           "proofs/theorem.md,\n"
                           "which the covers of dumbbell certify do not use.\n",
                           flight);
}

/// Of bodies, with what is not known.
std::string foundation(const Bodies& bodies) {
    const std::string number = exact_text(bodies.number);
    return (bodies.have_rods
                ? fmt::format(
                      "Proved: with ends of the ratio {} and a uniform rod of this mass (in units of that of "
                      "both ends),\nN falls from one value to the other there. That there are no "
                      "other falls, and no rises, is open.\n",
                      number)
                : fmt::format("Proved: at rho {} no motion has N collisions if Q <= Q_c(N), and some motion "
                              "has for every greater Q\n(N does not decrease with Q: L83). There N steps "
                              "from one value to the other.\n",
                              number)) +
           "At both ends of the enclosure N is proved, as by dumbbell certify: by orbits (L87 of\n"
           "proofs/plane.md) and by a motion.\n";
}

std::string row_verdict(const Row& row, const Report& report) {
    const auto& bodies = report.request.bodies;
    const std::string name = !bodies ? fmt::format("q_c({})", row.n)
                             : bodies->have_rods
                                 ? fmt::format("The mass at which N falls from {}", row.n)
                                 : fmt::format("Q_c({}; {})", row.n, exact_text(bodies->number));
    if (!row.ratio) {
        return fmt::format("{} was not enclosed in the time allowed.\n", name);
    }
    const Number p = shown_number(*row.ratio, report.request.digits);
    return fmt::format("{}{} = {}{}\n", name,
                       is_of_rods(report) ? fmt::format(" to {}", row.ratio->below) : "", p.value,
                       p.exact ? "" : "...");
}

std::string single_text(const Report& report) {
    const Row& row = report.rows.front();
    std::string text = row_verdict(row, report);
    if (!row.ratio) {
        return text;
    }
    const Number p = shown_number(*row.ratio, report.request.digits);
    text += fmt::format("\nProved in {} bits: at this mass ratio the maximum steps from {} to {}.\n",
                        row.ratio->bits, row.n - 1, row.n);
    text += p.exact ? "The number is exact.\n"
                    : fmt::format("It is within {} of the digits shown (cut off, not rounded).\n", p.radius);
    const flight::ExtremalFlight flight = flight::tangent_flight(row.n);
    const std::string what = fmt::format("flight {} of the {} orbit", flight.flight, orbit_name(row.n));
    text += flight::macro::is_long(row.n) ? long_foundation("J", what) : foundation(what);
    return text;
}

/// Of bodies: N at the least and at the greatest number of the enclosure.
std::pair<long, long> values_beside(const Row& row, const Report& report) {
    const Ratio ends = row.ratio.value_or(Ratio());
    return is_of_rods(report) ? std::pair(ends.n, ends.below) : std::pair(ends.below, ends.n);
}

TableLine heading(const Report& report) {
    return !report.request.bodies
               ? TableLine{"N", "q_c", "radius", "bits", "orbit", "flight"}
               : TableLine{"N", is_of_rods(report) ? "mass" : "Q_c", "radius", "bits", "from", "to"};
}

TableLine line_of(const Row& row, const Report& report, const char* more) {
    TableLine line{fmt::format("{}", row.n)};
    if (row.ratio) {
        const Number p = shown_number(*row.ratio, report.request.digits);
        line.insert(line.end(),
                    {p.value + (p.exact ? "" : more), p.radius, fmt::format("{}", row.ratio->bits)});
    } else {
        line.insert(line.end(), {"open", "-", "-"});
    }
    if (!report.request.bodies) {
        line.insert(line.end(), {orbit_name(row.n), fmt::format("{}", flight::tangent_flight(row.n).flight)});
    } else {
        const auto [from, to] = values_beside(row, report);
        line.insert(line.end(), {fmt::format("{}", from), fmt::format("{}", to)});
    }
    return line;
}

/// For people: which flight of which orbit decides is in the file and in JSON alone.
std::string table_text(const Report& report) {
    std::vector<TableLine> lines{{"N",
                                  is_of_rods(report)      ? "mass of the rod"
                                  : report.request.bodies ? "Q of the step"
                                                          : "mass ratio of the step",
                                  "to within", "bits of precision", "N before", "N after"}};
    for (const Row& row : report.rows) {
        lines.push_back(line_of(row, report, "..."));
    }
    for (TableLine& line : lines) {
        line.resize(report.request.bodies ? line.size() : 4);
    }
    return aligned(lines, 1);
}

std::string range_text(const Report& report) {
    const long enclosed = std::ranges::count_if(report.rows, has_ratio), open = open_in(report);
    const long all = enclosed + open;
    const auto& bodies = report.request.bodies;
    std::string text = table_text(report);
    text += fmt::format("{} in {:.2f} s with {}\n\n", plural(all, bodies ? "step" : "critical ratio"),
                        report.seconds, plural(report.request.jobs, "thread"));
    if (open > 0) {
        text += fmt::format("Not finished: {} of {} are open.\n", open, all);
        if (const auto n = first_unreached(report)) {
            text += fmt::format("Those from N = {} on are left out.\n", *n);
        }
    }
    if (enclosed > 0 && bodies) {
        text += foundation(*bodies) + "The digits are cut off, not rounded.\n";
    } else if (enclosed > 0) {
        text +=
            "Proved: at this mass ratio, q_c(N), the maximum steps from N - 1 to N.\n"
            "The digits are cut off, not rounded.\n";
        const bool first_is_long = flight::macro::is_long(report.request.first);
        const bool last_is_long = flight::macro::is_long(report.request.last);
        text += first_is_long ? "" : foundation("a flight of one of two orbits");
        const std::string from = fmt::format("From N = {} on, j", flight::macro::first_long);
        text +=
            last_is_long ? long_foundation(first_is_long ? "J" : from, "a flight of one of two orbits") : "";
    }
    return text;
}

/// Of the ends, beyond those of the number.
constexpr int more_digits = 20;

Json row_json(const Row& row, const Report& report) {
    Json json = Json::object({{"n", row.n}});
    if (!report.request.bodies) {
        json.add("orbit", orbit_name(row.n));
        json.add("flight", flight::tangent_flight(row.n).flight);
    }
    json.add("status", row.ratio ? "proved" : "open");
    if (row.ratio) {
        const Number p = shown_number(*row.ratio, report.request.digits);
        const int ends = report.request.digits + more_digits;
        json.add("q_c", p.value);
        json.add("radius", p.radius);
        json.add("exact", p.exact);
        json.add("lo", to_text(without_zeros(cut_down(row.ratio->q_lo, ends))));
        json.add("hi", to_text(without_zeros(cut_up(row.ratio->q_hi, ends))));
        json.add("bits", row.ratio->bits);
        if (report.request.bodies) {
            const auto [from, to] = values_beside(row, report);
            json.add("from", from);
            json.add("to", to);
        }
    }
    return json;
}

std::string method(long first, long last) {
    const std::string newton = "interval Newton: exactly one tangency in the bracket";
    const std::string counts = "numbers of collisions at both ends, by macro steps (L42)";
    if (flight::macro::is_long(first) || !flight::macro::is_long(last)) {
        return flight::macro::is_long(first) ? counts : newton;
    }
    return newton + "; from N = " + std::to_string(flight::macro::first_long) + " on " + counts;
}

}  // namespace

long open_in(const Report& report) {
    const long all = is_of_rods(report) ? static_cast<long>(report.rows.size()) : report.request.size();
    return all - std::ranges::count_if(report.rows, has_ratio);
}

std::string verdict(const Report& report) {
    std::string text;
    for (const Row& row : report.rows) {
        text += row_verdict(row, report);
    }
    return text;
}

void leave_out_unreached(Report& report) {
    auto& rows = report.rows;
    if (is_of_rods(report)) {
        return;
    }
    const auto last = std::find_if(rows.rbegin(), rows.rend(), has_ratio);
    rows.resize(std::max(1L, static_cast<long>(rows.rend() - last)));
}

std::string to_text(const Report& report) {
    const bool is_single = !report.request.bodies && report.request.first == report.request.last;
    std::string text = is_single ? single_text(report) : range_text(report);
    if (report.out) {
        text += fmt::format("Table: {}\n", one_line(*report.out));
    }
    return text;
}

Json to_json(const Report& report) {
    Json ratios = Json::array();
    for (const Row& row : report.rows) {
        ratios.add(row_json(row, report));
    }
    const auto& bodies = report.request.bodies;
    const auto number_if = [&](bool holds) { return holds ? Json(exact_text(bodies->number)) : Json(); };
    return Json::object(
        {{"schema", "dumbbell-critical-1"},
         {"method", bodies ? "bounds at both ends, by orbits and by a motion"
                           : method(report.request.first, report.request.last)},
         {"rests_on", bodies ? "proofs/body.md, L82 and L83" : "proofs/theorem.md, theorem 2"},
         {"rho", number_if(bodies && !bodies->have_rods)},
         {"rods_between", number_if(bodies && bodies->have_rods)},
         {"digits", report.request.digits},
         {"jobs", report.request.jobs},
         {"ratios", ratios},
         {"open", open_in(report)},
         {"left_out_from", first_unreached(report)},
         {"seconds", report.seconds},
         {"out", report.out}});
}

std::string to_tsv(const Report& report) {
    const auto joined = [](const TableLine& line) { return fmt::format("{}\n", fmt::join(line, "\t")); };
    std::string text =
        "# Critical mass ratios q_c(N), where the maximum steps from N - 1 to N. Every digit is proved (cut "
        "off, not\n"
        "# rounded), and q_c lies within the radius of the number. This rests on theorem 2 of "
        "proofs/theorem.md.\n# ";
    if (const auto& bodies = report.request.bodies) {
        text = "# Steps of bodies. " + foundation(*bodies);
        for (std::size_t end = text.find('\n'); end + 1 < text.size(); end = text.find('\n', end + 1)) {
            text.insert(end + 1, "# ");
        }
        text += "# ";
    }
    text += joined(heading(report));
    for (const Row& row : report.rows) {
        text += joined(line_of(row, report, ""));
    }
    return text;
}

}  // namespace dumbbell::critical
