#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>

#include "base/error.hpp"
#include "page/file.hpp"
#include "pictures/count_colours.hpp"
#include "pictures/start_plane.hpp"
#include "starts/answer/shares.hpp"
#include "starts/answer/writer.hpp"

namespace dumbbell::page {
namespace {

constexpr int deepest =
    400 * static_cast<int>(starts::axis_count);  // format-initial.md; bounds the shares' size
constexpr int window_digits = 5;                 // shown; the file has the window exactly

constexpr std::array<std::string_view, 2> incoming_names{"phi_over_pi", "s"};

/// A leaf apart from its box and the window of the first contact: open ones last, undecided ones before.
using Kind = std::tuple<bool, bool, long, long, int>;

enum FirstMass { no_mass, light_mass, heavy_mass };

Kind kind_of(const starts::Leaf& leaf) {
    const int mass = !leaf.first ? no_mass : leaf.first->heavy ? heavy_mass : light_mass;
    return {!leaf.most, leaf.most != leaf.least, leaf.most.value_or(0), leaf.least, mass};
}

/// The colour is that of its number of collisions; null: it has none.
Json kind_json(const Kind& kind, const std::map<Count, pictures::CountShade>& shades) {
    const auto& [is_open, undecided, most, least, mass] = kind;
    const auto shade = is_open || undecided ? shades.end() : shades.find(least);
    return Json::object(
        {{"least", least},
         {"most", is_open ? Json() : Json(most)},
         {"first", std::array{Json(), Json("light"), Json("heavy")}.at(static_cast<std::size_t>(mass))},
         {"colour",
          shade == shades.end() ? Json() : Json::array({shade->second.light, shade->second.dark})}});
}

/// The picture's tree and what its leaves add up to.
class Body {
  public:
    explicit Body(const std::vector<starts::Node>& nodes) {
        for (const starts::Node& node : nodes) {
            if (!node.split) {
                kinds_.emplace(kind_of(node.leaf), 0);
            }
        }
        int number = 0;
        for (auto& kind : kinds_) {
            kind.second = number++;
        }
        std::vector<int> depths{0};  // of the nodes to come: the next one last
        for (const starts::Node& node : nodes) {
            const int depth = depths.back();
            depths.pop_back();
            if (depth > deepest) {
                throw InputError(
                    fmt::format("a tree of initial conditions is more than {} levels deep", deepest));
            }
            if (node.split) {
                tree.push_back(split_of(static_cast<std::size_t>(*node.split)));
                depths.insert(depths.end(), 2, depth + 1);
            } else {
                tree.push_back(kinds_.at(kind_of(node.leaf)));
                add(node.leaf, depth);
            }
        }
    }

    PictureTree tree;

    [[nodiscard]] Json kinds() const {
        std::vector<Count> counts;  // that are exact; -1: the others
        for (const auto& [count, depths] : leaves_) {
            if (count >= 0) {
                counts.push_back(count);
            }
        }
        const auto shades = pictures::count_shades(counts);
        Json json = Json::array();
        for (const auto& kind : kinds_) {
            json.add(kind_json(kind.first, shades));
        }
        return json;
    }

    /// The certified share of the box by number of collisions; null: undecided.
    [[nodiscard]] Json shares() const {
        Json json = Json::array();
        for (const auto& [count, depths] : leaves_) {
            Rational share = 0;
            long boxes = 0;
            for (const auto& [depth, leaves] : depths) {
                share += Rational(leaves) / Rational(Integer(1) << static_cast<unsigned>(depth));
                boxes += leaves;
            }
            json.add(Json::object({{"collisions", count < 0 ? Json() : Json(count)},
                                   {"share", to_decimal(share, 6)},
                                   {"boxes", boxes}}));
        }
        return json;
    }

    /// From and until, rounded, for each leaf in order; nulls where the file has no window.
    [[nodiscard]] const Json& windows() const { return windows_; }

    [[nodiscard]] long least() const { return least_.value_or(0); }
    [[nodiscard]] std::optional<long> most() const { return any_open_ ? std::nullopt : std::optional(most_); }

  private:
    void add(const starts::Leaf& leaf, int depth) {
        const bool is_exact = leaf.most == leaf.least;
        windows_.add(leaf.first ? Json(rounded(leaf.first->from)) : Json());
        windows_.add(leaf.first ? Json(rounded(leaf.first->until)) : Json());
        ++leaves_[is_exact ? leaf.least : -1][depth];
        least_ = std::min(least_.value_or(leaf.least), leaf.least);
        most_ = std::max(most_, leaf.most.value_or(0));
        any_open_ = any_open_ || !leaf.most;
    }

    static double rounded(const Rational& x) {
        return parse_rational(to_decimal(x, window_digits)).convert_to<double>();
    }

    std::map<Kind, int> kinds_;
    Json windows_ = Json::array();
    std::map<long, std::map<int, long>> leaves_;  // by count (-1: undecided), by depth
    std::optional<long> least_;
    long most_ = 0;
    bool any_open_ = false;
};

}  // namespace

Json file_json(const starts::Certificate& certificate, const BoxBudget& budget) {
    const Body body(certificate.tree);
    Json axes = Json::array();
    for (std::size_t i = 0; i < (certificate.incoming ? incoming_names.size() : starts::axis_count); ++i) {
        axes.add(
            Json::object({{"name", certificate.incoming ? incoming_names.at(i) : starts::axis_names.at(i)},
                          {"lo", to_fraction(certificate.box.lo[i])},
                          {"hi", to_fraction(certificate.box.hi[i])}}));
    }
    const std::size_t leaves = leaves_of(body.tree);
    Json tree = tree_json(body.tree, budget);
    tree.add("axes", axes);
    return Json::object({{"claim", starts::claim_kind(certificate.incoming)},
                         {"ratio", to_fraction(certificate.box.upper(starts::Axis::ratio))},
                         {"bits", certificate.bits},
                         {"least", body.least()},
                         {"most", body.most()},
                         {"shares", body.shares()},
                         {"kinds", body.kinds()},
                         {"windows", share_of(leaves, budget) == leaves ? body.windows() : Json::array()},
                         {"tree", tree},
                         {"hatched", pictures::hatched_note}});
}

std::string claim_options(const starts::Certificate& certificate) {
    const Body body(certificate.tree);
    Rational decided = 0;
    for (const starts::ShareBounds& bounds : starts::share_bounds(certificate.tree)) {
        decided += bounds.lo;
    }
    return starts::claim_options(certificate.incoming, certificate.box, body.least(), body.most(), decided);
}

}  // namespace dumbbell::page
