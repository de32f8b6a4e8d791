#include "argument.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "audit/audit.hpp"
#include "audit/claimed_range.hpp"
#include "audit/leaf_boxes.hpp"
#include "base/error.hpp"
#include "collisions/leaf.hpp"
#include "collisions/names.hpp"
#include "collisions/reader.hpp"
#include "collisions/witness.hpp"
#include "flight/wedge.hpp"

namespace dumbbell_mutation {
namespace {

using namespace dumbbell;
using namespace dumbbell::collisions;

/// Something that could not be shown.
struct NotShown {
    std::string what;
};

/// Does what the prover says of a box confirm the leaf? Either the same reason, with hints that are not
/// greater; or no state of the section lies in the box, so that nothing said of them is false.
bool confirms(const std::optional<Leaf>& found, const Leaf& leaf) {
    if (!found) return false;
    if (found->reason == Reason::count || found->reason == Reason::once)
        return found->reason == leaf.reason && found->forward <= leaf.forward &&
               found->backward <= leaf.backward;
    return true;
}

/// With the bound that the leaf's own hints make, which is the claimed one or less.
template <class I>
bool judged(Chart chart, const Box& box, const Count& upper, const Leaf& leaf) {
    const Count said = leaf.reason == Reason::count ? 1 + leaf.forward + leaf.backward : upper;
    std::optional<Leaf> found;
    judge<I>(chart, {&box, 1}, said, {&found, 1});
    return said <= upper && confirms(found, leaf);
}

template <class I>
bool witnessed(const Piece& piece) {
    const Witness& w = *piece.witness;
    const auto found =
        checked_witness<I>(w.e, w.eta, piece.q_lo, piece.q_hi, std::max(w.forward, w.backward));
    return found && found->forward >= w.forward && found->backward >= w.backward;
}

/// L17: exactly, at the greatest r, where the counts are least.
bool wedge_witnessed(const Piece& piece) {
    const Witness& w = *piece.witness;
    const auto returns = [&](const Rational& r) {
        return 1 + 2 * r * w.eta - r > 0 && 2 + r * w.eta - w.eta >= 0 && r * w.eta < 1;
    };
    const Rational r = 1 / piece.q_lo;
    if (w.e != 0 || !returns(r) || !returns(1 / piece.q_hi)) return false;
    const Rational mu = (2 + r * w.eta - w.eta) / (1 + 2 * r * w.eta - r);
    return flight::wedge_count(r * w.eta, r, w.forward) >= w.forward &&
           flight::wedge_count(r * mu, r, w.backward) >= w.backward;
}

class Pieces {
  public:
    explicit Pieces(const Certificate& certificate) : certificate_(certificate) {}

    void check(const Piece& piece, std::size_t number) {
        number_ = number;
        if (piece.upper && piece.cover.equal_masses) {
            if (*piece.upper < 2 || certificate_.scene != Scene::dumbbell) fail("L7 says 2");
        } else if (piece.upper) {
            for (const ChartTree& part : piece.cover.charts) tree(piece, part);
        }
        if (piece.lower > 0) lower(piece);
    }
    [[nodiscard]] std::size_t leaves() const { return leaves_; }

  private:
    [[noreturn]] void fail(const std::string& what) const {
        throw NotShown{fmt::format("piece {}: {}", number_, what)};
    }

    void tree(const Piece& piece, const ChartTree& part) {
        const audit::Boxes boxes = audit::leaf_boxes(part.chart, piece.q_lo, piece.q_hi, part.tree);
        std::size_t i = 0;
        for (const Node& node : part.tree) {
            if (node.split) continue;
            const audit::BoxEnds& ends = boxes.leaves.at(i++);
            const auto side = [&](std::size_t axis) {
                return std::pair(boxes.lo(ends, axis), boxes.hi(ends, axis));
            };
            const auto [e, slope, q] = std::tuple(side(0), side(1), side(2));
            const Box box{e.first, e.second, slope.first, slope.second, q.first, q.second};
            if (!closes(part.chart, box, *piece.upper, node.leaf, piece.bits))
                fail(fmt::format("chart {}, leaf {}: {} {} {}", name(part.chart), i, name(node.leaf.reason),
                                 node.leaf.forward, node.leaf.backward));
            ++leaves_;
        }
    }
    static bool closes(Chart chart, const Box& box, const Count& upper, const Leaf& leaf, int bits) {
        const Count bound =
            std::min(upper, Count(1L << 62));  // some charts take no greater one; less says more
        if (judged<Interval>(chart, box, bound, leaf)) return true;
        const PrecisionScope scope(std::max(bits, 128));
        return judged<BigInterval>(chart, box, bound, leaf);
    }

    void lower(const Piece& piece) const {
        if (!piece.witness || piece.lower > piece.witness->total()) fail("the witness says less");
        if (certificate_.scene != Scene::dumbbell) {
            if (!wedge_witnessed(piece)) fail("the witness");
            return;
        }
        const PrecisionScope scope(std::max(piece.bits, 128));
        if (!witnessed<Interval>(piece) && !witnessed<BigInterval>(piece)) fail("the witness");
    }

    const Certificate& certificate_;
    std::size_t number_ = 0, leaves_ = 0;
};

/// Is the verifier's word what the file says, as the prover's reader reads it?
void compare_claims(const Certificate& c, const std::pair<Rational, Rational>& range,
                    const dumbbell_verify::Verified& proof) {
    const auto& claim = proof.claim;
    std::optional<Count> upper = 0;
    Count lower = c.pieces.front().lower;
    long gaps = 0, open = 0;
    for (const Piece& piece : c.pieces) {
        upper = upper && piece.upper ? std::optional(std::max(*upper, *piece.upper)) : std::nullopt;
        lower = std::min(lower, piece.lower);
        gaps += piece.status() == Status::gap ? 1 : 0;
        open += piece.status() == Status::open ? 1 : 0;
    }
    const bool same_upper =
        upper.has_value() == claim.upper.has_value() && (!upper || claim.upper->get_str() == upper->str());
    if (to_fraction(range.first) != dumbbell_verify::to_string(claim.lo) ||
        to_fraction(range.second) != dumbbell_verify::to_string(claim.hi) || !same_upper ||
        claim.lower.get_str() != lower.str() || c.pieces.size() != claim.pieces ||
        static_cast<std::uint64_t>(gaps) != claim.gaps || static_cast<std::uint64_t>(open) != claim.open)
        throw NotShown{"the verdict states another claim than the file"};
    if (proof.heavy_once != (upper && c.section != Section::turning))
        throw NotShown{"heavy-at-most=1 without a cover that shows it, or not stated"};
}

}  // namespace

Argument second_argument(const std::string& path, const dumbbell_verify::Verified& proof) {
    try {
        if (const auto* it = std::get_if<dumbbell_verify::Initial>(&proof.other))
            return initial_argument(path, *it);
        if (const auto* it = std::get_if<dumbbell_verify::Adiabatic>(&proof.other))
            return adiabatic_argument(path, it);
        const Certificate certificate = read_certificate(path);
        const auto range = audit::claimed_range(path);
        compare_claims(certificate, range, proof);
        const audit::Audit audited = audit::audit(certificate, range);
        if (!audited.tiles()) throw NotShown{audited.faults.front()};
        Pieces pieces(certificate);
        for (std::size_t i = 0; i < certificate.pieces.size(); ++i)
            pieces.check(certificate.pieces[i], i + 1);
        return {true, fmt::format("audited, {} leaves and all witnesses judged again by the prover",
                                  pieces.leaves())};
    } catch (const NotShown& fault) {
        return {false, fault.what};
    } catch (const InputError& error) {
        return {false, error.what()};
    }
}

}  // namespace dumbbell_mutation
