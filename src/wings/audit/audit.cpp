#include "audit/audit.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "audit/tiling.hpp"
#include "base/error.hpp"
#include "collisions/chart.hpp"
#include "collisions/leaf_boxes.hpp"
#include "collisions/reader.hpp"
#include "collisions/section.hpp"
#include "file/sealed_lines.hpp"

namespace dumbbell::audit {

using collisions::Axis;
using collisions::Boxes;
using collisions::Certificate;
using collisions::Chart;
using collisions::Piece;

namespace {

/// A place in a leaf: the fraction if it is short, else a decimal.
std::string shown(const Rational& x) {
    std::string fraction = to_fraction(x);
    return fraction.size() <= 60 ? fraction : "about " + to_decimal(x, 12);
}

/// `leaf 7 (e 1/2..1/1, eta 0/1..4/1, q 10/1..10/1)`
std::string leaf_text(const Boxes& boxes, Chart chart, std::size_t index) {
    std::string ranges;
    for (const Axis axis : collisions::all_axes) {
        const auto number = static_cast<std::size_t>(axis);
        ranges += fmt::format("{}{} {}..{}", ranges.empty() ? "" : ", ", axis_name(chart, axis),
                              shown(boxes.lo(boxes.leaves[index], number)),
                              shown(boxes.hi(boxes.leaves[index], number)));
    }
    return fmt::format("leaf {} ({})", index + 1, ranges);
}

std::string fault_text(const Boxes& boxes, Chart chart, const Tiling& tiling) {
    switch (*tiling.fault) {
        case Fault::reversed:
            return leaf_text(boxes, chart, tiling.first) + " has an end before its beginning";
        case Fault::sticks_out:
            return leaf_text(boxes, chart, tiling.first) + " reaches beyond the root box";
        case Fault::overlap:
            return fmt::format("{} and {} overlap", leaf_text(boxes, chart, tiling.first),
                               leaf_text(boxes, chart, tiling.second));
        case Fault::missing_area:
            return fmt::format("area {} of the root's {} is in no leaf", shown(tiling.missing),
                               shown(tiling.area));
    }
    throw BrokenInvariant("unknown fault");
}

std::vector<std::string> range_faults(const Certificate& certificate,
                                      const std::pair<Rational, Rational>& claimed) {
    std::vector<std::string> faults;
    Rational reached = claimed.first;
    std::size_t number = 0;
    for (const Piece& piece : certificate.pieces) {
        ++number;
        if (piece.q_lo != reached) {
            faults.push_back(fmt::format("piece {} begins at ratio {}, not at {}", number,
                                         to_fraction(piece.q_lo), to_fraction(reached)));
        }
        if (piece.q_hi < piece.q_lo) {
            faults.push_back(fmt::format("piece {} ends before it begins", number));
        }
        reached = piece.q_hi;
    }
    if (reached != claimed.second) {
        faults.push_back(fmt::format("the pieces end at ratio {}, not at {}", to_fraction(reached),
                                     to_fraction(claimed.second)));
    }
    return faults;
}

/// Audits the pieces one after the other.
class Auditor {
  public:
    Auditor(const Certificate& certificate, Observer& observer)
        : observer_(observer),
          total_(static_cast<std::size_t>(certificate.leaves())),
          needed_(collisions::row_of(certificate.system.section).charts) {}

    void add(const Piece& piece) {
        ++result.pieces;
        if (!piece.upper) {
            ++result.without_cover;
            return;
        }
        if (piece.cover.equal_masses) {
            ++result.equal_masses;
            if (piece.q_lo != 1 || piece.q_hi != 1) {
                fault("", "equal-masses is for the ratio 1 alone");
            }
            return;
        }
        if (piece.cover.symmetric) {
            return;  // no boxes: L72
        }
        if (!std::ranges::equal(piece.cover.charts, needed_, {}, &collisions::ChartTree::chart)) {
            fault("", "its cover lacks a chart or has a wrong one");
        }
        for (const collisions::ChartTree& tree : piece.cover.charts) {
            add(piece, tree);
        }
    }

    Audit result;

  private:
    void add(const Piece& piece, const collisions::ChartTree& tree) {
        ++result.charts;
        const std::string where = fmt::format(", chart {}", row_of(tree.chart).name);
        try {
            const Boxes boxes = leaf_boxes(tree.chart, piece.q_lo, piece.q_hi, tree.tree);
            const std::size_t before = result.leaves;
            const Tiling tiling = check_tiling(boxes, [&](double done) {
                show(before + static_cast<std::size_t>(done * static_cast<double>(boxes.leaves.size())));
            });
            result.leaves += tiling.leaves;
            result.pairs += tiling.pairs;
            if (tiling.fault) {
                fault(where, fault_text(boxes, tree.chart, tiling));
            }
        } catch (const InputError& error) {
            fault(where, error.what());
        }
        show(result.leaves);
    }

    void fault(const std::string& where, const std::string& what) {
        result.faults.push_back(fmt::format("piece {}{}: {}", result.pieces, where, what));
    }

    void show(std::size_t done) const {
        if (done > 0) {
            observer_.update(done, total_, std::nullopt);
        }
    }

    Observer& observer_;
    std::size_t total_;
    std::span<const Chart> needed_;
};

}  // namespace

Audit audit(const Certificate& certificate, const std::pair<Rational, Rational>& claimed,
            Observer& observer) {
    Auditor auditor(certificate, observer);
    auditor.result.faults = range_faults(certificate, claimed);
    for (const Piece& piece : certificate.pieces) {
        auditor.add(piece);
    }
    return std::move(auditor.result);
}

Audit audit_file(const std::string& path, Observer& observer) {
    need_exact_geometry();
    const Certificate certificate = collisions::read_certificate(path);
    const collisions::ClaimedHead head = collisions::read_head(path);
    if (certificate.sha256.empty()) {
        is_damaged(path);
    }
    observer.enter("auditing", "leaves");
    return audit(certificate, {head.range.lo, head.range.hi}, observer);
}

}  // namespace dumbbell::audit
