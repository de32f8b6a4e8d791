#include "collisions/proof_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

#include "base/printable.hpp"
#include "collisions/names.hpp"
#include "collisions/orbit_text.hpp"
#include "collisions/section.hpp"
#include "flight/paper_bound.hpp"
#include "number/decimal.hpp"
#include "words/printed.hpp"
#include "words/text_table.hpp"

namespace dumbbell::collisions {
namespace {

std::string range_text(const Range& range) {
    return range.is_single() ? exact_text(range.lo) : exact_text(range.lo) + " : " + exact_text(range.hi);
}

const SectionRow& row_of(const ProofReport& report) { return row_of(report.claim.system.section); }

std::vector<const Piece*> pieces_of(const ProofReport& report) {
    std::vector<const Piece*> pieces;
    std::ranges::transform(report.rows, std::back_inserter(pieces), &ReportRow::piece);
    return pieces;
}

/// Not computed for the greatest ratios.
bool has_paper_bound(const ProofReport& report, const Piece& piece) {
    return row_of(report).has_paper_bound && piece.q_hi <= flight::paper_bound_limit();
}

/// What the ratio is: the mass ratio, or of a body Q.
std::string ratio_word(const ProofReport& report) { return report.claim.system.rho ? "Q" : "mass ratio"; }

std::string rho_text(const ProofReport& report) {
    const auto& rho = report.claim.system.rho;
    return rho ? fmt::format(", rho {}", exact_text(*rho)) : "";
}

std::string value_text(const Piece& piece) {
    switch (piece.status()) {
        case Status::exact:
            return fmt::format("{}", *piece.upper);
        case Status::gap:
            return fmt::format("{} {} {}", piece.lower, *piece.upper == piece.lower + 1 ? "or" : "to",
                               *piece.upper);
        default:
            return piece.lower > 0 ? fmt::format(">= {}", piece.lower) : "open";
    }
}

/// The paper's bound grows with q: one number, or those at both ends.
std::string paper_text(const ProofReport& report, const Piece& piece) {
    if (!has_paper_bound(report, piece)) {
        return "-";
    }
    const long lo = flight::paper_bound(piece.q_lo);
    const long hi = flight::paper_bound(piece.q_hi);
    return lo == hi ? fmt::format("{}", lo) : fmt::format("{}-{}", lo, hi);
}

struct Counts {
    long exact = 0, gaps = 0, open = 0;
    Count least{}, most{};  ///< the values of the exact pieces, of which there is one
};

Counts count_statuses(const ProofReport& report) {
    Counts counts;
    for (const ReportRow& row : report.rows) {
        ++(row.piece->status() == Status::exact ? counts.exact
           : row.piece->status() == Status::gap ? counts.gaps
                                                : counts.open);
        if (row.piece->status() == Status::exact) {
            counts.most = std::max(counts.most, row.piece->lower);
            counts.least = counts.exact == 1 ? row.piece->lower : std::min(counts.least, row.piece->lower);
        }
    }
    return counts;
}

/// Which pieces have one value, and which values: `the piece with one value N = 4`.
std::string pieces_with_value(const Counts& counts) {
    if (counts.exact == 1) {
        return fmt::format("the piece with one value N = {}", counts.most);
    }
    const std::string pieces = fmt::format("each of the {} pieces with one value N", counts.exact);
    return counts.least == counts.most ? fmt::format("{} = {}", pieces, counts.most)
                                       : fmt::format("{}, from {} to {}", pieces, counts.least, counts.most);
}

/// What to type so that `trace` follows a start at mass ratio q.
std::string trace_command(const Rational& q, const WitnessStart& start) {
    return fmt::format("dumbbell trace {} --phi {} --phidot {} --y {} --ydot {}{}", exact_text(q), start.phi,
                       start.phidot, start.y, start.ydot,
                       start.digits == 0 ? "" : fmt::format(" --digits {}", start.digits));
}

/// A start in the air with as many collisions, unless the orbit is printed with it; nothing of a range.
std::string start_sentence(const ProofReport& report) {
    const ReportRow& row = report.rows.front();
    const bool is_wanted = report.claim.range.is_single() && row.start && row.orbit.empty();
    return is_wanted ? fmt::format("A start in the air with as many: {}\n",
                                   trace_command(row.piece->q_lo, *row.start))
                     : "";
}

std::string single_sentence(const ProofReport& report) {
    const Piece& piece = *report.rows.front().piece;
    const SectionRow& words = row_of(report);
    const std::string q =
        fmt::format("{} {}{}", ratio_word(report), exact_text(report.claim.range.lo), rho_text(report));
    if (piece.status() == Status::exact) {
        const std::string times = plural(*piece.upper, "time");
        return fmt::format("Proved: at {} no {} more than {}, and some {} {}.\n", q, words.hits, times,
                           words.hits_it, times);
    }
    const std::string known = piece.lower > 0 ? fmt::format("only this is proved: some {} at least {}",
                                                            words.hits, plural(piece.lower, "time"))
                                              : std::string("nothing is proved");
    return fmt::format("Not decided: at {} {}.\n", q, known);
}

/// By the smaller share of the two: one like 0.999999999999 says less, and rounds to 1.
std::string decided_text(const Rational& undecided, bool some) {
    if (undecided == 0) {
        return "Decided: the whole range.\n";
    }
    if (undecided == 1) {
        return some ? "Decided: single ratios only.\n" : "Decided: nothing of the range.\n";
    }
    return undecided > Rational(1, 2)
               ? fmt::format("Decided: {} of the range.\n",
                             to_text(without_zeros(cut_down(1 - undecided, 3))))
               : fmt::format("Decided: all but {} of the range.\n", rounded_up(undecided));
}

std::string range_sentence(const ProofReport& report) {
    const Counts counts = count_statuses(report);
    const SectionRow& words = row_of(report);
    std::string text;
    if (counts.exact > 0) {
        text = fmt::format(
            "Proved: in {}, and for every {} in it{},\nno {} more than N times and some {} N times. ",
            pieces_with_value(counts), ratio_word(report), rho_text(report), words.hits, words.hits_it);
    } else if (counts.gaps == 0) {
        text = "Not decided. ";
    }
    if (counts.gaps > 0) {
        text += fmt::format(
            "In the {} around the critical {} the maximum is {}. ",
            counts.gaps == 1 ? "gap" : fmt::format("{} gaps", counts.gaps),
            counts.gaps == 1 ? "ratio" : "ratios",
            row_of(report).is_monotone ? "from the one value to the other" : "one of the two values");
    }
    if (counts.open > 0) {
        text += fmt::format("{} {} open. ", plural(counts.open, "piece"), counts.open == 1 ? "is" : "are");
    }
    return text + decided_text(report.undecided, counts.exact > 0);
}

std::string part_sentence(const ProofReport& report) {
    if (!report.part) {
        return {};
    }
    const auto& [part, whole, range] = *report.part;
    return fmt::format("Part {} of {} of {} {}: those from {} to {}.\n", part.number, part.of,
                       report.claim.system.rho ? "Q" : "the mass ratios", range_text(whole),
                       exact_text(range.lo), exact_text(range.hi));
}

Json part_json(const RatioPart& part) {
    return Json::object({{"number", part.part.number},
                         {"of", part.part.of},
                         {"lo", to_fraction(part.whole.lo)},
                         {"hi", to_fraction(part.whole.hi)}});
}

Json start_json(const WitnessStart& start) {
    return Json::object({{"phi", start.phi},
                         {"phidot", start.phidot},
                         {"y", start.y},
                         {"ydot", start.ydot},
                         {"digits", start.digits}});
}

Json row_json(const ProofReport& report, const ReportRow& row) {
    const Piece& piece = *row.piece;
    const bool has_margin = row.margin > 0;
    Json json = Json::object(
        {{"lo", to_fraction(piece.q_lo)},
         {"hi", to_fraction(piece.q_hi)},
         {"upper", piece.upper},
         {"lower", piece.lower},
         {"status", name(piece.status())},
         {"paper_bound", has_paper_bound(report, piece) ? Json(flight::paper_bound(piece.q_hi)) : Json()},
         {"leaves", piece.cover.leaves()},
         {"bits", piece.bits},
         {"margin", has_margin ? Json(row.margin) : Json()},
         {"width", has_margin ? Json(row.width) : Json()}});
    if (!row.orbit.empty()) {
        json.add("witness", Json::object({{"ratio", to_fraction(piece.q_lo)},
                                          {"collisions", collisions_json(row.orbit)},
                                          {"start", row.start ? start_json(*row.start) : Json()}}));
    }
    return json;
}

/// The lemma that proves the upper bound without boxes; empty: boxes do.
std::string_view lemma_of(const Cover& cover) {
    return cover.equal_masses ? "L7" : cover.symmetric ? "L72" : cover.orbits ? "L87" : "";
}

std::string pieces_table(const ProofReport& report) {
    const bool paper = row_of(report).has_paper_bound;
    bool by_lemma = false;
    std::vector<TableLine> lines;
    const auto add = [&](TableLine line, const std::string& bound) {
        if (paper) {
            line.insert(line.begin() + 2, bound);
        }
        lines.push_back(std::move(line));
    };
    add({ratio_word(report), "N", "boxes", "time"}, "paper");
    for (const ReportRow& row : report.rows) {
        const Piece& piece = *row.piece;
        const std::string_view lemma = lemma_of(piece.cover);
        by_lemma = by_lemma || !lemma.empty();
        add({range_text({piece.q_lo, piece.q_hi}), value_text(piece),
             lemma.empty() ? fmt::format("{}", piece.cover.leaves()) : fmt::format("by {}", lemma),
             fmt::format("{:.3f} s", row.seconds)},
            paper_text(report, piece));
    }
    return aligned(lines, 0) +
           fmt::format(
               "{}N: the greatest number of collisions;{} boxes: the parts that together hold all "
               "motions, each with a reason{}.\n",
               report.claim.system.rho ? "Q: of the body (certify --help bodies); " : "",
               paper ? " paper: the bound of the source paper;" : "",
               by_lemma ? "; by L...: a lemma of proofs/ needs none" : "");
}

}  // namespace

std::string verdict(const ProofReport& report) {
    return report.claim.range.is_single() ? single_sentence(report)
                                          : part_sentence(report) + range_sentence(report);
}

std::string to_text(const ProofReport& report) {
    const bool is_single = report.claim.range.is_single();  // else the answer follows what may be long
    std::string text = is_single ? verdict(report) + '\n' : "";
    text += pieces_table(report);
    text += is_single ? "\n"
                      : fmt::format("{} in {:.2f} s with {}\n\n{}", plural(report.rows.size(), "piece"),
                                    report.seconds, plural(report.jobs, "thread"), verdict(report));
    text += start_sentence(report);
    if (heavy_at_most_once(report.claim, pieces_of(report))) {
        text += "In every trajectory the heavy mass hits the floor at most once.\n";
    }
    if (report.out) {
        text += fmt::format("Certificate: {} (sha256 {})\nCheck it:    dumbbell verify {} {}\n",
                            one_line(*report.out), *report.sha256,
                            options_to_check(report.claim, pieces_of(report)), shell_file(*report.out));
    }
    return text;
}

Json to_json(const ProofReport& report) {
    Json pieces = Json::array();
    for (const ReportRow& row : report.rows) {
        pieces.add(row_json(report, row));
    }
    Json json = Json::object(
        {{"schema", "dumbbell-certify-1"},
         {"scene", row_of(report).scene},
         {"section", row_of(report).section},
         {"ratio", Json::object({{"lo", to_fraction(report.claim.range.lo)},
                                 {"hi", to_fraction(report.claim.range.hi)}})},
         {"part", report.part ? part_json(*report.part) : Json()},
         {"gap", to_fraction(report.claim.gap)},
         {"jobs", report.jobs},
         {"pieces", pieces},
         {"heavy_at_most_once", heavy_at_most_once(report.claim, pieces_of(report)) ? Json(true) : Json()},
         {"decided_fraction", decided_fraction(report.undecided)},
         {"undecided_share", to_fraction(report.undecided)},
         {"seconds", report.seconds},
         {"out", report.out},
         {"sha256", report.sha256}});
    if (const auto& rho = report.claim.system.rho) {
        json.add("rho", Json::object({{"lo", to_fraction(*rho)}, {"hi", to_fraction(*rho)}}));
    }
    return json;
}

std::string orbits_to_text(const ProofReport& report) {
    std::string text;
    for (const ReportRow& row : report.rows) {
        if (row.orbit.empty()) {
            continue;
        }
        text += fmt::format(
            "Witness at mass ratio {}: {} collisions. Rod length 1; phi in radians; y: height of the centre "
            "of mass;\n"
            "unit of time: phidot^2 + q (ydot / beta2)^2 = 1. Each number is enclosed: value+-radius.\n{}"
            "Smallest margin (angle between flight and floor, in the kinetic metric): {} rad\n"
            "Widths of the enclosures along the orbit:\n{}\n",
            exact_text(row.piece->q_lo), row.orbit.size(), collisions_text(row.orbit),
            rounded_down(row.margin), widths_text(row.orbit));
        if (row.start) {
            text += fmt::format(
                "A start in the air, near this orbit, that has {} as well; the command was run, and proves "
                "it:\n  {}\n\n",
                plural(row.orbit.size(), "collision"), trace_command(row.piece->q_lo, *row.start));
        } else if (!row.why_no_start.empty()) {
            text += fmt::format("No start in the air: {}.\n\n", row.why_no_start);
        }
    }
    return text;
}

}  // namespace dumbbell::collisions
