#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <vector>

#include "collisions/chart.hpp"
#include "collisions/claim.hpp"
#include "collisions/leaf_boxes.hpp"
#include "collisions/names.hpp"
#include "collisions/section.hpp"
#include "collisions/witness.hpp"
#include "flight/paper_bound.hpp"
#include "number/decimal.hpp"
#include "page/file.hpp"
#include "pictures/count_colours.hpp"
#include "pictures/palette.hpp"

namespace dumbbell::page {

using collisions::Certificate;
using collisions::Piece;
using collisions::System;

namespace {

using collisions::Axis;
namespace palette = pictures::palette;

/// A reason other than a count: what it says of the states in its box, and the box's colour.
struct ReasonStyle {
    std::string_view about;
    pictures::Shade colour;
};

ReasonStyle style_of(collisions::Reason reason) {
    using enum collisions::Reason;
    switch (reason) {
        case count:
            break;
        case outside:
            return {"no state of the section lies here", palette::outside};
        case meets:
            return {"the outgoing ray meets the bridge, so the chart bridge covers these states",
                    palette::meets};
        case meets_reversed:
            return {"the incoming ray comes from the bridge, so the chart bridge covers these states",
                    palette::meets_reversed};
        case once:
            return {"what comes back is too steep to meet the bridge again", palette::once};
    }
    return {};
}

/// The different leaves of a file, numbered so that of two numbers the greater one says more: counts last, by
/// their sums.
class Kinds {
  public:
    explicit Kinds(const Certificate& certificate) {
        for (const Piece& piece : certificate.pieces) {
            for (const collisions::ChartTree& tree : piece.cover.charts) {
                for (const collisions::Node& node : tree.tree) {
                    if (!node.split) {
                        numbers_.emplace(key(node.leaf), 0);
                        ++leaves_[node.leaf.reason];
                    }
                }
            }
        }
        int number = 0;
        for (auto& kind : numbers_) {
            kind.second = number++;
        }
    }

    [[nodiscard]] int number(const collisions::Leaf& leaf) const { return numbers_.at(key(leaf)); }

    [[nodiscard]] Json json() const {
        std::vector<Count> counts;
        for (const auto& [key, number] : numbers_) {
            const auto& [counted, both, forward, backward, reason] = key;
            if (counted) {
                counts.push_back(1 + both);
            }
        }
        const auto shades = pictures::count_shades(counts);
        Json kinds = Json::array();
        for (const auto& [key, number] : numbers_) {
            const auto& [counted, both, forward, backward, reason] = key;
            const ReasonStyle style = style_of(reason);
            const pictures::Shade colour = counted ? shades.at(1 + both).shade() : style.colour;
            kinds.add(Json::object({{"reason", name(reason)},
                                    {"about", style.about},
                                    {"forward", forward},
                                    {"backward", backward},
                                    {"colour", Json::array({colour.light, colour.dark})}}));
        }
        return kinds;
    }

    [[nodiscard]] Json totals() const {
        Json totals = Json::object();
        for (const auto& [reason, leaves] : leaves_) {
            totals.add(name(reason), leaves);
        }
        return totals;
    }

  private:
    using Key = std::tuple<bool, Count, Count, Count, collisions::Reason>;

    static Key key(const collisions::Leaf& leaf) {
        return {leaf.reason == collisions::Reason::count, leaf.forward + leaf.backward, leaf.forward,
                leaf.backward, leaf.reason};
    }

    std::map<Key, int> numbers_;
    std::map<collisions::Reason, long> leaves_;
};

Json axes_json(collisions::Chart chart, const Piece& piece) {
    const collisions::Boxes root = collisions::root_of(chart, piece.q_lo, piece.q_hi);
    Json axes = Json::array();
    for (const Axis axis : collisions::all_axes) {
        const auto number = static_cast<std::size_t>(axis);
        axes.add(Json::object({{"name", axis_name(chart, axis)},
                               {"lo", to_fraction(root.lo(root.root, number))},
                               {"hi", to_fraction(root.hi(root.root, number))}}));
    }
    return axes;
}

Json chart_json(const collisions::ChartTree& chart, const Piece& piece, const Kinds& kinds,
                const BoxBudget& budget) {
    PictureTree tree;
    tree.reserve(chart.tree.size());
    for (const collisions::Node& node : chart.tree) {
        tree.push_back(node.split ? split_of(static_cast<std::size_t>(*node.split))
                                  : kinds.number(node.leaf));
    }
    Json json = tree_json(tree, budget);
    json.add("chart", row_of(chart.chart).name);
    json.add("axes", axes_json(chart.chart, piece));
    return json;
}

/// Of a witness close to the corner a contact that has as many collisions in the middle of the piece, where
/// the page draws it, if one is found.
Json witness_json(const Piece& piece, const System& system) {
    const collisions::Witness& witness = *piece.witness;
    std::optional<collisions::Witness> drawn = witness;
    if (witness.place == collisions::Place::corner) {
        const Rational q = exact(std::sqrt((piece.q_lo * piece.q_hi).convert_to<double>()));
        drawn = collisions::contact_of_body<Interval>({q, q}, as_long(witness.total()), system);
    }
    return Json::object({{"chart", name(witness.place)},
                         {"e", drawn ? Json(to_fraction(drawn->e)) : Json()},
                         {"eta", drawn ? Json(to_fraction(drawn->eta)) : Json()},
                         {"forward", witness.forward},
                         {"backward", witness.backward}});
}

const char* symbol_of(const Certificate& certificate) { return certificate.system.rho ? "Q" : "q"; }

Json piece_json(const Piece& piece, const Certificate& certificate, const Kinds& kinds,
                const BoxBudget& budget) {
    const bool has_paper = row_of(certificate.system.section).has_paper_bound && piece.q_lo >= 1 &&
                           piece.q_hi <= flight::paper_bound_limit();
    Json trees = Json::array();
    for (const collisions::ChartTree& chart : piece.cover.charts) {
        trees.add(chart_json(chart, piece, kinds, budget));
    }
    return Json::object(
        {{"lo", to_fraction(piece.q_lo)},
         {"hi", to_fraction(piece.q_hi)},
         {"lo_text", exact_text(piece.q_lo)},
         {"hi_text", exact_text(piece.q_hi)},
         {"symbol", symbol_of(certificate)},
         {"status", name(piece.status())},
         {"upper", piece.upper},
         {"lower", piece.lower},
         {"bits", piece.bits},
         {"leaves", piece.cover.leaves()},
         {"equal_masses", piece.cover.equal_masses},
         {"symmetric", piece.cover.symmetric},
         {"paper", has_paper ? Json::array({flight::paper_bound(piece.q_lo), flight::paper_bound(piece.q_hi)})
                             : Json()},
         {"witness", piece.witness ? witness_json(piece, certificate.system) : Json()},
         {"trees", trees}});
}

/// The greatest upper and the least lower bound; none if a piece has no upper bound.
std::pair<std::optional<Count>, Count> bounds_of(const Certificate& certificate) {
    std::optional<Count> upper = 0;
    Count lower = certificate.pieces.front().lower;
    for (const Piece& piece : certificate.pieces) {
        upper = upper && piece.upper ? std::optional(std::max(*upper, *piece.upper)) : std::nullopt;
        lower = std::min(lower, piece.lower);
    }
    return {upper, lower};
}

}  // namespace

Json file_json(const Certificate& certificate, const BoxBudget& budget) {
    const Kinds kinds(certificate);
    const collisions::SectionRow& row = row_of(certificate.system.section);
    const auto [upper, lower] = bounds_of(certificate);
    Json pieces = Json::array();
    for (const Piece& piece : certificate.pieces) {
        pieces.add(piece_json(piece, certificate, kinds, budget));
    }
    const auto& rho = certificate.system.rho;
    const std::string where =
        rho ? fmt::format(" of a body with \u03c1 = d2/d1 = {} (in a plane, as long as it meets no corner)",
                          exact_text(*rho))
            : "";
    return Json::object(
        {{"claim", "collisions"},
         {"scene", row.scene},
         {"system", rho ? fmt::format("The body with \u03c1 = {}", exact_text(*rho)) : "The dumbbell"},
         {"where", where},
         {"symbol", symbol_of(certificate)},
         {"ratio", rho ? "Q = (d1/k)\u00b2" : "mass ratio q"},
         {"rho", rho ? Json(to_fraction(*rho)) : Json()},
         {"has_orbits", row.has_orbits},
         {"section", row.section},
         {"lo_text", exact_text(certificate.q_lo())},
         {"hi_text", exact_text(certificate.q_hi())},
         {"upper", upper},
         {"lower", lower},
         {"kinds", kinds.json()},
         {"totals", kinds.totals()},
         {"pieces", pieces}});
}

std::string claim_options(const Certificate& certificate) {
    return options_to_check(claim_of(certificate), pieces_of(certificate));
}

}  // namespace dumbbell::page
