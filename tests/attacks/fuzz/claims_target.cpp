// Well-formed certificates with wrong claims: true ones (shipped files) of which leaves, trees, witnesses,
// bounds and ratios are changed. What the verifier accepts must be true: the claim by Theorem 2, and every
// leaf before the line that it rejects by the simulated trajectories of its states.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "certificates.hpp"
#include "collisions/names.hpp"
#include "collisions/reader.hpp"
#include "collisions/section.hpp"
#include "collisions/writer.hpp"
#include "leaf_truth.hpp"
#include "scratch.hpp"
#include "target.hpp"
#include "truth.hpp"
#include "verify/program/verify.hpp"

namespace {

using namespace dumbbell_fuzz;
using namespace dumbbell;
using namespace dumbbell::collisions;

/// Kept cases depend on the order: add at the end.
const std::vector<Certificate>& bases() {
    static const std::vector<Certificate> all = [] {
        std::vector<Certificate> result;
        for (const char* file :
             {"certificates/q-1.dbc", "certificates/q-10.dbc", "certificates/q-100.dbc",
              "certificates/q-1e4.dbc", "certificates/stairs-1-100.dbc",
              "tests/attacks/fuzz/bases/full-3.dbc", "tests/attacks/fuzz/bases/full-6.dbc"})
            result.push_back(read_certificate(std::string(DUMBBELL_PROJECT) + "/" + file));
        return result;
    }();
    return all;
}

const Piece& any_base_piece(Choices& choices) {
    const Certificate& base = bases()[choices.below(bases().size())];
    return base.pieces[choices.below(base.pieces.size())];
}

/// One to three neighbouring pieces of a true certificate.
Certificate any_true_claim(Choices& choices) {
    const Certificate& base = bases()[choices.below(bases().size())];
    const std::size_t first = choices.below(base.pieces.size());
    const std::size_t last = std::min(first + choices.below(3), base.pieces.size() - 1);
    Certificate claim = base;
    claim.generator.program = "fuzz";
    claim.pieces.assign(base.pieces.begin() + static_cast<std::ptrdiff_t>(first),
                        base.pieces.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    return claim;
}

// The wrongs. Each takes a piece of the claim, or one of its trees and a node of it.

Count changed(const Count& n, Choices& choices) { return std::max<Count>(0, n + choices.between(-2, 2)); }

void change_leaf(Node& node, Choices& choices) {
    switch (choices.below(4)) {
        case 0:
            node.leaf.forward = changed(node.leaf.forward, choices);
            break;
        case 1:
            node.leaf.backward = changed(node.leaf.backward, choices);
            break;
        case 2:
            if (node.split) {
                node.split = any_axis(choices);
            } else {
                std::swap(node.leaf.forward, node.leaf.backward);
            }
            break;
        default:
            if (!node.split) node = any_leaf(choices);
    }
}

using Iterator = Tree::iterator;
Iterator at(Tree& tree, std::size_t node) { return tree.begin() + static_cast<std::ptrdiff_t>(node); }

void replace(Tree& tree, std::size_t node, const Tree& by) {
    const std::size_t end = end_of_subtree(tree, node);
    tree.erase(at(tree, node), at(tree, end));
    tree.insert(at(tree, node), by.begin(), by.end());
}

void change_tree(ChartTree& part, Choices& choices) {
    Tree& tree = part.tree;
    const std::size_t node = choices.below(std::min<std::size_t>(tree.size(), 65536));
    const std::size_t end = end_of_subtree(tree, node);
    const Tree here(at(tree, node), at(tree, end));
    switch (choices.below(6)) {
        case 0:  // a gap closed: one leaf in place of many
            replace(tree, node, {choices.coin() ? here.back() : any_leaf(choices)});
            break;
        case 1: {  // needlessly split
            Tree twice{{any_axis(choices), {}}};
            twice.insert(twice.end(), here.begin(), here.end());
            twice.insert(twice.end(), here.begin(), here.end());
            replace(tree, node, twice);
            break;
        }
        case 2:  // the halves swapped
            if (here.front().split) {
                const std::size_t middle = end_of_subtree(here, 1);
                std::rotate(at(tree, node + 1), at(tree, node + middle), at(tree, end));
            }
            break;
        case 3: {  // a part of another tree
            const Piece& other = any_base_piece(choices);
            if (other.cover.charts.empty()) break;
            const Tree& from = other.cover.charts[choices.below(other.cover.charts.size())].tree;
            const std::size_t begin = choices.below(std::min<std::size_t>(from.size(), 65536));
            const auto first = from.begin() + static_cast<std::ptrdiff_t>(begin);
            const auto last = from.begin() + static_cast<std::ptrdiff_t>(end_of_subtree(from, begin));
            replace(tree, node, Tree(first, last));
            break;
        }
        case 4: {
            Tree random;
            grow_any_tree(choices, 6, random);
            replace(tree, node, random);
            break;
        }
        default:
            change_leaf(tree[node], choices);
    }
}

/// An upper bound that fewer collisions fulfil, mostly with counts that fit it.
void strengthen_upper(Piece& piece, Choices& choices) {
    if (!piece.upper) return;
    piece.upper = changed(*piece.upper, choices);
    if (choices.below(4) == 3) return;
    const bool forward_first = choices.coin();
    for (ChartTree& part : piece.cover.charts)
        for (Node& node : part.tree) {
            Leaf& leaf = node.leaf;
            const Count too_many = 1 + leaf.forward + leaf.backward - *piece.upper;
            if (node.split || leaf.reason != Reason::count || too_many <= 0) continue;
            dumbbell::Count& first = forward_first ? leaf.forward : leaf.backward;
            dumbbell::Count& second = forward_first ? leaf.backward : leaf.forward;
            const Count taken = std::min(first, too_many);
            first -= taken;
            second = std::max<Count>(0, second - (too_many - taken));
        }
}

void strengthen_lower(Piece& piece, Choices& choices) {
    if (!piece.witness) return;
    const long more = choices.between(-1, 2);
    piece.lower = std::max<Count>(0, piece.lower + more);
    (choices.coin() ? piece.witness->forward : piece.witness->backward) += std::max(0L, more);
    if (piece.upper) piece.upper = std::max(*piece.upper, piece.lower);
}

void close_gap(Piece& piece, Choices& choices) {
    if (!piece.upper) return;
    if (choices.coin()) {
        piece.upper = piece.lower;
    } else if (piece.witness) {
        piece.lower = *piece.upper;
    }
}

/// Dyadic, not below 0, no longer than the format allows.
Rational moved(const Rational& x, Choices& choices) {
    const Rational by = small_number(choices);
    const Rational result = choices.coin() ? x + by : x * (Rational(1) + by);
    const bool is_short =
        result >= 0 && numerator(result) < Integer(1) << 400 && denominator(result) < Integer(1) << 400;
    return is_short ? result : x;
}

void change_witness(Piece& piece, Choices& choices) {
    if (!piece.witness) return;
    Witness& witness = *piece.witness;
    switch (choices.below(5)) {
        case 0:
            witness.e = moved(witness.e, choices);
            break;
        case 1:
            witness.eta = moved(witness.eta, choices);
            break;
        case 2:
            witness.forward = changed(witness.forward, choices);
            break;
        case 3:
            witness.backward = changed(witness.backward, choices);
            break;
        default:
            if (const Piece& other = any_base_piece(choices); other.witness) witness = *other.witness;
    }
}

/// Exactly, from the numbers of the table.
Rational rational(const mpq_class& x) { return Rational(x.get_mpq_t()); }

/// A ratio near this one, or near a critical ratio of about this many collisions.
Rational near(const Rational& q, const Piece& piece, Choices& choices) {
    Rational base = q;
    if (choices.coin()) {
        const long n = as_long(piece.lower) + choices.between(-1, 2);
        base = rational(critical_ratio(
            static_cast<std::size_t>(std::clamp(n, 3L, static_cast<long>(greatest_critical())))));
    }
    return std::max(Rational(1), base * (Rational(1) + small_number(choices)));
}

/// The pieces still follow one another.
void change_ratios(Certificate& claim, std::size_t i, Choices& choices) {
    Piece& piece = claim.pieces[i];
    const bool lower_end = choices.coin();
    const Rational q = near(lower_end ? piece.q_lo : piece.q_hi, piece, choices);
    if (choices.below(4) == 0) {
        claim.pieces = {piece};
        claim.pieces[0].q_lo = claim.pieces[0].q_hi = q;
        return;
    }
    if (lower_end) {
        if (q > piece.q_hi || (i > 0 && q < claim.pieces[i - 1].q_lo)) return;
        piece.q_lo = q;
        if (i > 0) claim.pieces[i - 1].q_hi = q;
    } else {
        if (q < piece.q_lo || (i + 1 < claim.pieces.size() && q > claim.pieces[i + 1].q_hi)) return;
        piece.q_hi = q;
        if (i + 1 < claim.pieces.size()) claim.pieces[i + 1].q_lo = q;
    }
}

void change_kind(Certificate& claim, Choices& choices) {
    Section& section = claim.system.section;
    if (section != Section::turning) {
        section = choices.coin() ? Section::full : Section::plain;
        for (Piece& piece : claim.pieces)
            for (std::size_t i = 0; i < 2 && i < piece.cover.charts.size(); ++i)
                piece.cover.charts[i].chart = row_of(section).charts[i];
    }
}

void do_wrong(Certificate& claim, Choices& choices) {
    const std::size_t i = choices.below(claim.pieces.size());
    Piece& piece = claim.pieces[i];
    auto& charts = piece.cover.charts;
    switch (choices.below(12)) {
        case 0:
            strengthen_upper(piece, choices);
            break;
        case 1:
            strengthen_lower(piece, choices);
            break;
        case 2:
            close_gap(piece, choices);
            break;
        case 3:
        case 4:
            change_witness(piece, choices);
            break;
        case 5:
        case 6:
            change_ratios(claim, i, choices);
            break;
        case 7:
            piece.bits = choices.coin() ? 53 : static_cast<int>(choices.between(53, 128));
            break;
        case 8:
            change_kind(claim, choices);
            break;
        case 9:
            if (!charts.empty()) {
                const Tree first = charts.front().tree;
                charts.front().tree = charts.back().tree;
                charts.back().tree = first;
            }
            break;
        default:
            if (!charts.empty()) change_tree(charts[choices.below(charts.size())], choices);
    }
}

// What must be true.

struct Box {
    std::array<double, 3> lo, hi;  ///< position, slope, ratio
};

struct PlacedLeaf {
    Chart chart;
    Leaf leaf;
    Box box;
};

/// The least power of two >= x, k >= 0, as the root boxes have it.
double root_end(const Rational& x) {
    Rational power = 1;
    while (power < x) power *= 2;
    return power.convert_to<double>();
}

Box root_of(Chart chart, const Piece& piece) {
    const double lo = piece.q_lo.convert_to<double>(), hi = piece.q_hi.convert_to<double>();
    switch (chart) {
        case Chart::bridge:
        case Chart::light:
            return {{0, 0, lo}, {2, root_end(piece.q_hi), hi}};
        case Chart::departure:
        case Chart::plain_departure:
            return {{0, 0, lo}, {2, 2, hi}};
        default:
            return {{0, 0, lo}, {4, root_end(piece.q_hi + 1), hi}};
    }
}

/// What stands on lines before `end`, where the verifier found fault, in files of the writer.
struct Accepted {
    std::vector<PlacedLeaf> leaves;
    std::vector<const Piece*> witnessed;
};
Accepted accepted_before(std::uint64_t end, const Certificate& claim) {
    Accepted result;
    std::uint64_t line = 8;  // of the header
    for (const Piece& piece : claim.pieces) {
        line += 3;
        if (piece.cover.equal_masses) ++line;
        for (const ChartTree& part : piece.cover.charts) {
            if (!piece.upper) break;
            ++line;
            std::vector<Box> boxes{root_of(part.chart, piece)};
            for (const Node& node : part.tree) {
                const Box box = boxes.back();
                boxes.pop_back();
                if (++line >= end) return result;
                if (!node.split) {
                    result.leaves.push_back({part.chart, node.leaf, box});
                    continue;
                }
                const auto axis = static_cast<std::size_t>(*node.split);
                Box lower = box, upper = box;
                lower.hi.at(axis) = upper.lo.at(axis) = (box.lo.at(axis) + box.hi.at(axis)) / 2;
                boxes.push_back(upper);
                boxes.push_back(lower);
            }
        }
        line += piece.lower > 0 ? 2 : 1;
        if (line >= end) return result;
        if (piece.lower > 0) result.witnessed.push_back(&piece);
    }
    return result;
}

void check_samples(const Accepted& accepted, Choices& choices) {
    for (const Piece* piece : accepted.witnessed)
        for (const Rational& q : {piece->q_lo, piece->q_hi, Rational((piece->q_lo + piece->q_hi) / 2)})
            must_hold(*piece->witness, q.convert_to<Real>());
    constexpr int samples = 6;
    const std::vector<PlacedLeaf>& leaves = accepted.leaves;
    for (int i = 0; i < samples && !leaves.empty(); ++i) {
        const PlacedLeaf& leaf = leaves[choices.sample_below(leaves.size())];
        std::array<Real, 3> x{};
        for (std::size_t k = 0; k < 3; ++k)
            x.at(k) = leaf.box.lo.at(k) +
                      static_cast<Real>(choices.sample()) * (leaf.box.hi.at(k) - leaf.box.lo.at(k));
        must_hold(leaf.chart, leaf.leaf, {x[0], x[1], x[2]});
    }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static MemoryFile file;
    Choices choices(data, size);
    Certificate claim = any_true_claim(choices);
    for (int wrongs = 0; wrongs < 12 && !choices.none_left(); ++wrongs) do_wrong(claim, choices);
    // Beyond, a leaf is too much work; in the full section it grows with the ratio, not with its root.
    const bool is_full = row_of(claim.system.section).shows_heavy_once;
    if (claim.q_hi() > (is_full ? 500 : 20'000)) return 0;

    dumbbell_verify::Request settings;
    settings.max_bits = 128;
    settings.scene = row_of(claim.system.section).scene;
    std::uint64_t end = std::numeric_limits<std::uint64_t>::max();
    try {
        (void)dumbbell_verify::verify(file.holding(render(claim).text), settings);
        for (const Piece& piece : claim.pieces) must_be_true(piece);
    } catch (const dumbbell_verify::Failure& failure) {
        must(failure.verdict == dumbbell_verify::Verdict::rejected ||
                 failure.verdict == dumbbell_verify::Verdict::limit,
             "a well-formed file is verified, rejected or too much");
        end = failure.line;
    }
    check_samples(accepted_before(end, claim), choices);
    return 0;
}
