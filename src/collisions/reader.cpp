#include "collisions/reader.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "collisions/chart.hpp"
#include "collisions/names.hpp"
#include "collisions/section.hpp"
#include "file/lines.hpp"

namespace dumbbell::collisions {
namespace {

Node node_from(Lines& lines, Chart chart) {
    const auto& fields = lines.next();
    const std::string& word = fields[0];
    if (word == "split" && fields.size() == 2) {
        if (const auto axis = axis_named(chart, fields[1])) {
            return {axis, {}};
        }
    }
    const auto reason = value_named<Reason>(word);
    const std::size_t counts = reason != Reason::count ? 0 : row_of(chart).counts_both_ways ? 2 : 1;
    if (reason && fields.size() == 1 + counts) {
        return {std::nullopt,
                {*reason, counts > 0 ? lines.count(fields[1]) : Count(),
                 counts > 1 ? lines.count(fields[2]) : Count()}};
    }
    lines.fail();
}

ChartTree tree_from(Lines& lines, Chart chart) {
    Tree tree;
    for (long missing = 1; missing > 0;) {
        tree.push_back(node_from(lines, chart));
        missing += tree.back().split ? 1 : -1;
    }
    return {chart, std::move(tree)};
}

UpperBound orbits_from(Lines& lines) {
    const auto& fields = lines.next();
    if (fields[0] != orbits_word || fields.size() % 2 != 0) {
        lines.fail();
    }
    UpperBound bound{lines.number(fields[1])};
    for (std::size_t i = 2; i < fields.size(); i += 2) {
        bound.orbits.emplace_back(lines.number(fields[i]), lines.dyadic(fields[i + 1]));
    }
    return bound;
}

Cover cover_from(Lines& lines, std::span<const Chart> charts) {
    Cover cover;
    if (charts.empty()) {
        cover.orbits = orbits_from(lines);
    }
    for (const Chart chart : charts) {
        const auto& fields = lines.next();
        if (cover.charts.empty() && fields.size() == 1 && fields[0] == equal_masses_word) {
            cover.equal_masses = true;
            return cover;
        }
        if (cover.charts.empty() && fields.size() == 1 && fields[0] == symmetric_word) {
            cover.symmetric = true;
            return cover;
        }
        if (fields.size() != 2 || fields[0] != "chart" || fields[1] != row_of(chart).name) {
            lines.fail();
        }
        cover.charts.push_back(tree_from(lines, chart));
    }
    return cover;
}

Piece piece_from(Lines& lines, std::span<const Chart> charts) {
    Piece piece;
    const auto& range = lines.expect("piece", 3);
    piece.q_lo = lines.ratio(range[1]);
    piece.q_hi = lines.ratio(range[2]);
    piece.bits = static_cast<int>(std::min(lines.number(lines.expect("bits", 2)[1]), long{most_file_bits}));
    const std::string upper = lines.expect("upper", 2)[1];
    if (upper != "none") {
        piece.upper = lines.count(upper);
        piece.cover = cover_from(lines, charts);
    }
    piece.lower = lines.count(lines.expect("lower", 2)[1]);
    if (piece.lower > 0) {
        const auto& w = lines.expect("witness", 6);
        const auto place = value_named<Place>(w[1]);
        if (!place) {
            lines.fail();
        }
        piece.witness =
            Witness{lines.dyadic(w[2]), lines.dyadic(w[3]), lines.count(w[4]), lines.count(w[5]), *place};
    }
    return piece;
}

/// What a file with this claim is about, if it is no certificate about mass ratios; nullptr: nothing known.
const char* other_subject(std::string_view claim) {
    if (claim == "initial-conditions") {
        return "initial conditions (dumbbell trace)";
    }
    if (claim == "incoming") {
        return "all incoming trajectories (dumbbell trace --incoming)";
    }
    if (claim == "law") {
        return "the law for every mass ratio (dumbbell law)";
    }
    return claim.starts_with("adiabatic-") ? "the adiabatic invariant (dumbbell adiabatic)" : nullptr;
}

ClaimedHead head_from(Lines& lines, const std::string& path) {
    const Head head = lines.expect_head();
    const auto section = section_in_file(head.scene, head.lemmas, head.section);
    if (const char* subject = other_subject(head.claim)) {
        throw InputError(
            fmt::format("'{}' is about {}: a certificate with a cover of mass ratios is needed here "
                        "(dumbbell certify RATIO --out FILE); dumbbell verify reads both",
                        path, subject));
    }
    if (!section || head.claim != "collisions") {
        lines.fail();
    }
    const auto ends = [&](const char* word) -> Range {
        const auto& fields = lines.expect(word, 3);
        return {lines.ratio(fields[1]), lines.ratio(fields[2])};
    };
    const Range range = ends("ratio");
    std::optional<Rational> rho;
    if (*section == Section::body || *section == Section::plain_body) {
        const Range heights = ends("rho");
        if (!heights.is_single()) {
            throw InputError(fmt::format("'{}' is about a range of rho: only the verifiers read it", path));
        }
        rho = heights.lo;
    }
    const auto pieces = static_cast<std::size_t>(lines.number(lines.expect("pieces", 2)[1]));
    if (pieces == 0) {
        lines.fail();
    }
    return {head.generator, {*section, rho}, range, pieces};
}

}  // namespace

ClaimedHead read_head(const std::string& path) {
    Lines lines(path);
    return head_from(lines, path);
}

std::size_t claimed_pieces(const std::string& path) try {
    return read_head(path).pieces;
} catch (const InputError&) {
    return 0;  // who reads it says what is wrong with it
}

Certificate read_certificate(const NamedFile& file) {
    Lines lines(file);
    const ClaimedHead head = head_from(lines, file.path);
    Certificate certificate{.generator = head.generator, .pieces = {}, .system = head.system};
    const std::span<const Chart> charts = row_of(head.system.section).charts;
    for (std::size_t i = 0; i < head.pieces; ++i) {
        certificate.pieces.push_back(piece_from(lines, charts));
    }
    certificate.sha256 = lines.digest();
    return certificate;
}

}  // namespace dumbbell::collisions
