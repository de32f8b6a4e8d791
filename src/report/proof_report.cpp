#include "report/proof_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>

#include "certificate/names.hpp"
#include "model/paper_bound.hpp"
#include "report/orbit_text.hpp"
#include "report/printed.hpp"

namespace dumbbell {
namespace {

std::string_view name(Status status) {
    switch (status) {
        case Status::exact:
            return "exact";
        case Status::gap:
            return "gap";
        default:
            return "open";
    }
}

std::string range_text(const Rational& lo, const Rational& hi, int digits) {
    return lo == hi ? to_decimal(lo, digits) : to_decimal(lo, digits) + " : " + to_decimal(hi, digits);
}

std::string value_text(const Piece& piece) {
    switch (piece.status()) {
        case Status::exact:
            return fmt::format("{}", *piece.upper);
        case Status::gap:
            return fmt::format("{} or {}", piece.lower, *piece.upper);
        default:
            return piece.lower > 0 ? fmt::format(">= {}", piece.lower) : "open";
    }
}

/// The paper's bound grows with q: one number, or those at both ends; none for ratios that it is not computed
/// for.
std::string paper_text(const Piece& piece) {
    if (piece.q_hi > paper_bound_limit()) {
        return "-";
    }
    const long lo = paper_bound(piece.q_lo);
    const long hi = paper_bound(piece.q_hi);
    return lo == hi ? fmt::format("{}", lo) : fmt::format("{}-{}", lo, hi);
}

struct Counts {
    long exact = 0, gaps = 0, open = 0;
};

Counts count_statuses(const ProofReport& report) {
    Counts counts;
    for (const ReportRow& row : report.rows) {
        ++(row.piece->status() == Status::exact ? counts.exact
           : row.piece->status() == Status::gap ? counts.gaps
                                                : counts.open);
    }
    return counts;
}

std::string counted(long n, std::string_view one) {
    return fmt::format("{} {}{}", n, one, n == 1 ? "" : "s");
}

/// How clear of tangency the witness's collisions are, and how narrowly it is known.
std::string witness_sentence(const ReportRow& row) {
    if (row.margin <= 0) {
        return {};
    }
    return fmt::format(
        "Its orbit meets the floor at an angle of {} rad or more, and the heights along it are enclosed to "
        "{}.\n",
        rounded_down(row.margin), rounded_up(row.width));
}

std::string single_sentence(const ProofReport& report) {
    const Piece& piece = *report.rows.front().piece;
    const std::string q = to_decimal(report.q_lo, 17);
    if (piece.status() == Status::exact) {
        return fmt::format(
            "Proved: at mass ratio {} no trajectory hits the floor more than {}, and some trajectory hits "
            "it {}.\n{}",
            q, counted(*piece.upper, "time"), counted(*piece.upper, "time"),
            witness_sentence(report.rows.front()));
    }
    const std::string known =
        piece.lower > 0 ? fmt::format("only this is proved: some trajectory hits the floor at least {}",
                                      counted(piece.lower, "time"))
                        : std::string("nothing is proved");
    return fmt::format("Not decided: at mass ratio {} {}.\n", q, known);
}

/// The share that is not decided, at least: a share like 0.999999999999 says less, and rounds to 1.
std::string decided_text(double fraction) {
    if (fraction == 1) {
        return "Decided: the whole range.\n";
    }
    return fmt::format("Decided: all but {} of the range.\n", rounded_up(1 - fraction));
}

std::string range_sentence(const ProofReport& report) {
    const Counts counts = count_statuses(report);
    std::string text;
    if (counts.exact > 0) {
        text = fmt::format(
            "Proved: in {} with one value N, and for every mass ratio in it, no trajectory hits the floor "
            "more than N times\n"
            "and some trajectory hits it N times. ",
            counts.exact == 1 ? "the piece" : fmt::format("each of the {} pieces", counts.exact));
    } else if (counts.gaps == 0) {
        text = "Not decided. ";
    }
    if (counts.gaps > 0) {
        text += fmt::format("In the {} around the critical {} the maximum is one of the two values. ",
                            counts.gaps == 1 ? "gap" : fmt::format("{} gaps", counts.gaps),
                            counts.gaps == 1 ? "ratio" : "ratios");
    }
    if (counts.open > 0) {
        text += fmt::format("{} {} open. ", counted(counts.open, "piece"), counts.open == 1 ? "is" : "are");
    }
    return text + decided_text(report.decided_fraction);
}

/// What a cover of the full section proves beside the count (its chart `again`, L19).
bool heavy_at_most_once(const ProofReport& report) {
    return report.section != Section::turning &&
           std::all_of(report.rows.begin(), report.rows.end(),
                       [](const ReportRow& row) { return row.piece->upper.has_value(); });
}

}  // namespace

std::string to_text(const ProofReport& report) {
    struct Line {
        std::string ratio, value, paper, boxes, time;
    };
    std::vector<Line> lines{{"mass ratio", "N", "paper", "boxes", "time"}};
    for (const ReportRow& row : report.rows) {
        const Piece& piece = *row.piece;
        lines.push_back({range_text(piece.q_lo, piece.q_hi, 13), value_text(piece), paper_text(piece),
                         fmt::format("{}", piece.cover.leaves()), fmt::format("{:.3f} s", row.seconds)});
    }
    std::array<std::size_t, 5> widths{};
    for (const Line& line : lines) {
        widths = {std::max(widths[0], line.ratio.size()), std::max(widths[1], line.value.size()),
                  std::max(widths[2], line.paper.size()), std::max(widths[3], line.boxes.size()),
                  std::max(widths[4], line.time.size())};
    }
    std::string text;
    for (const Line& line : lines) {
        fmt::format_to(std::back_inserter(text), "{:<{}}  {:>{}}  {:>{}}  {:>{}}  {:>{}}\n", line.ratio,
                       widths[0], line.value, widths[1], line.paper, widths[2], line.boxes, widths[3],
                       line.time, widths[4]);
    }
    fmt::format_to(std::back_inserter(text), "{} in {:.2f} s with {}\n\n",
                   counted(static_cast<long>(report.rows.size()), "piece"), report.seconds,
                   counted(report.jobs, "thread"));
    text += report.q_lo == report.q_hi ? single_sentence(report) : range_sentence(report);
    if (heavy_at_most_once(report)) {
        text += "In every trajectory the heavy mass hits the floor at most once.\n";
    }
    if (report.out) {
        fmt::format_to(std::back_inserter(text),
                       "Certificate: {} (sha256 {})\nCheck it:    dumbbell verify {}{}\n", *report.out,
                       *report.sha256,
                       report.scene == Scene::dumbbell ? "" : fmt::format("--scene {} ", name(report.scene)),
                       *report.out);
    }
    return text;
}

nlohmann::ordered_json to_json(const ProofReport& report) {
    nlohmann::ordered_json pieces = nlohmann::ordered_json::array();
    for (const ReportRow& row : report.rows) {
        const Piece& piece = *row.piece;
        nlohmann::ordered_json entry{{"lo", to_fraction(piece.q_lo)},
                                     {"hi", to_fraction(piece.q_hi)},
                                     {"upper", nullptr},
                                     {"lower", piece.lower},
                                     {"status", name(piece.status())},
                                     {"paper_bound", nullptr},
                                     {"leaves", piece.cover.leaves()},
                                     {"bits", piece.bits},
                                     {"margin", row.margin},
                                     {"width", row.width}};
        if (piece.upper) {
            entry["upper"] = *piece.upper;
        }
        if (piece.q_hi <= paper_bound_limit()) {
            entry["paper_bound"] = paper_bound(piece.q_hi);
        }
        if (!row.orbit.empty()) {
            entry["witness"] = {{"ratio", to_fraction(piece.q_lo)},
                                {"collisions", collisions_json(row.orbit)}};
        }
        pieces.push_back(std::move(entry));
    }
    nlohmann::ordered_json json{
        {"schema", "dumbbell-certify-1"},
        {"scene", name(report.scene)},
        {"section", name(report.section)},
        {"lemmas", lemma_set(report.section)},
        {"ratio", {{"lo", to_fraction(report.q_lo)}, {"hi", to_fraction(report.q_hi)}}},
        {"gap", to_fraction(report.gap)},
        {"jobs", report.jobs},
        {"pieces", std::move(pieces)},
        {"heavy_at_most_once", heavy_at_most_once(report)},
        {"decided_fraction", report.decided_fraction},
        {"seconds", report.seconds},
        {"out", nullptr},
        {"sha256", nullptr}};
    if (report.out) {
        json["out"] = *report.out;
        json["sha256"] = *report.sha256;
    }
    return json;
}

std::string orbits_to_text(const ProofReport& report) {
    std::string text;
    for (const ReportRow& row : report.rows) {
        if (row.orbit.empty()) {
            continue;
        }
        fmt::format_to(
            std::back_inserter(text),
            "Witness at mass ratio {}: {} collisions. Rod length 1; phi in radians; y: height of the centre "
            "of mass;\n"
            "unit of time: phidot^2 + q (ydot / beta2)^2 = 1. Each number is enclosed: value+-radius.\n{}"
            "Smallest margin (angle between flight and floor, in the kinetic metric): {:.6g} rad\n"
            "Widths of the enclosures along the orbit:\n{}\n",
            to_decimal(row.piece->q_lo, 17), row.orbit.size(), collisions_text(row.orbit), row.margin,
            widths_text(row.orbit));
    }
    return text;
}

}  // namespace dumbbell
