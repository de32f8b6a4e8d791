#include "collisions/reader.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "base/ended_early.hpp"
#include "base/error.hpp"
#include "collisions/names.hpp"
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
    const auto reason = reason_named(word);
    const std::size_t counts = reason != Reason::count ? 0 : counts_both_ways(chart) ? 2 : 1;
    if (reason && fields.size() == 1 + counts) {
        return {std::nullopt,
                {*reason, counts > 0 ? lines.count(fields[1]) : Count(),
                 counts > 1 ? lines.count(fields[2]) : Count()}};
    }
    lines.fail();
}

ChartTree tree_from(Lines& lines, Chart chart, Trees trees, const Interrupted& interrupted) {
    Tree tree;
    for (long missing = 1; missing > 0;) {
        go_on(interrupted);
        Node node = node_from(lines, chart);
        missing += node.split ? 1 : -1;
        if (trees == Trees::kept) {
            tree.push_back(node);
        }
    }
    return {chart, std::move(tree)};
}

Cover cover_from(Lines& lines, const std::vector<Chart>& charts, Trees trees,
                 const Interrupted& interrupted) {
    Cover cover;
    for (const Chart chart : charts) {
        const auto& fields = lines.next();
        if (cover.charts.empty() && fields.size() == 1 && fields[0] == "equal-masses") {
            cover.equal_masses = true;
            return cover;
        }
        if (fields.size() != 2 || fields[0] != "chart" || fields[1] != name(chart)) {
            lines.fail();
        }
        cover.charts.push_back(tree_from(lines, chart, trees, interrupted));
    }
    return cover;
}

constexpr std::array witness_charts{Chart::bridge, Chart::wedge};

Piece piece_from(Lines& lines, const std::vector<Chart>& charts, Trees trees,
                 const Interrupted& interrupted) {
    go_on(interrupted);
    Piece piece;
    const auto& range = lines.expect("piece", 3);
    piece.q_lo = lines.ratio(range[1]);
    piece.q_hi = lines.ratio(range[2]);
    piece.bits = static_cast<int>(std::min(lines.number(lines.expect("bits", 2)[1]), 4096L));
    const std::string upper = lines.expect("upper", 2)[1];
    if (upper != "none") {
        piece.upper = lines.count(upper);
        piece.cover = cover_from(lines, charts, trees, interrupted);
    }
    piece.lower = lines.count(lines.expect("lower", 2)[1]);
    if (piece.lower > 0) {
        const auto& w = lines.expect("witness", 6);
        const auto chart = std::find_if(witness_charts.begin(), witness_charts.end(),
                                        [&](Chart c) { return w[1] == name(c); });
        if (chart == witness_charts.end()) {
            lines.fail();
        }
        piece.witness =
            Witness{lines.dyadic(w[2]), lines.dyadic(w[3]), lines.count(w[4]), lines.count(w[5]), *chart};
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

}  // namespace

PieceReader::PieceReader(const std::string& path, Trees trees, Interrupted interrupted)
    : lines_(path), trees_(trees), interrupted_(std::move(interrupted)) {
    const Head head = lines_.expect_head();
    const auto scene = scene_named(head.scene);
    const auto section = section_spelled({head.lemmas, head.section});
    if (const char* subject = other_subject(head.claim)) {
        throw InputError(
            fmt::format("'{}' is about {}: a certificate with a cover of mass ratios is needed here "
                        "(dumbbell certify RATIO --out FILE); dumbbell verify reads both",
                        path, subject));
    }
    if (!scene || !section || head.claim != "collisions") {
        lines_.fail();
    }
    head_.generator = head.generator;
    head_.scene = *scene;
    head_.section = *section;
    const auto& range = lines_.expect("ratio", 3);
    q_lo_ = lines_.ratio(range[1]);
    q_hi_ = lines_.ratio(range[2]);
    pieces_ = static_cast<std::size_t>(lines_.number(lines_.expect("pieces", 2)[1]));
    if (pieces_ == 0) {
        lines_.fail();
    }
}

Piece PieceReader::next() {
    return piece_from(lines_, charts_of(head_.scene, head_.section), trees_, interrupted_);
}

std::size_t claimed_pieces(const std::string& path) try {
    return PieceReader(path, Trees::passed_over).pieces();
} catch (const InputError&) {
    return 0;  // who reads it says what is wrong with it
}

Certificate read_certificate(const std::string& path) {
    PieceReader in(path, Trees::kept);
    Certificate certificate = in.head();
    for (std::size_t i = 0; i < in.pieces(); ++i) {
        certificate.pieces.push_back(in.next());
    }
    certificate.sha256 = in.digest();
    return certificate;
}

}  // namespace dumbbell::collisions
