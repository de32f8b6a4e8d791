#include "adiabatic/writer.hpp"
#include "number/decimal.hpp"
#include "page/file.hpp"
#include "pictures/palette.hpp"

namespace dumbbell::page {
namespace {

constexpr int shown_digits = 6;

/// A bound C >= 0 for reading: rounded up, so that it still is one.
std::string shown_above(const Rational& x) {
    return x > 0 ? to_text(without_zeros(cut_up(x, shown_digits))) : spelled(x);
}

/// An attained value B for reading: rounded down, so that it still is attained.
std::string shown_below(const Rational& x) {
    return x > 0 ? to_text(without_zeros(cut_down(x, shown_digits))) : spelled(x);
}

Json range_json(const std::pair<Rational, Rational>& range) {
    return Json::array({spelled(range.first), spelled(range.second)});
}

Json axis_json(const char* name, const std::string& lo, const std::string& hi) {
    return Json::object({{"name", name}, {"lo", lo}, {"hi", hi}});
}

Json tree_of(const adiabatic::Certificate& certificate, const BoxBudget& budget) {
    PictureTree tree;
    for (const adiabatic::Node& node : certificate.tree) {
        tree.push_back(node.split     ? split_of(static_cast<std::size_t>(*node.split))
                       : node.outside ? 0
                                      : 1 + node.by_class);
    }
    Json json = tree_json(tree, budget);
    const auto& [lo, hi] = certificate.hypotheses.delta;
    json.add("axes", Json::array({axis_json("u", "0/1", "2/1"), axis_json("sigma", "0/1", "0/1"),
                                  axis_json("s", "0/1", "1/1"), axis_json("v", "0/1", "2/1"),
                                  axis_json("delta", to_fraction(lo), to_fraction(hi))}));
    return json;
}

Json kinds_json(const adiabatic::Certificate& certificate) {
    Json kinds = Json::array({Json::object(
        {{"reason", "outside"},
         {"colour", Json::array({pictures::palette::outside.light, pictures::palette::outside.dark})}})});
    const std::size_t classes = std::max<std::size_t>(1, certificate.classes.size());
    for (std::size_t i = 0; i < classes; ++i) {
        const char* colour = pictures::palette::classes.at(i % pictures::palette::classes.size());
        kinds.add(
            Json::object({{"reason", "bound"}, {"class", i}, {"colour", Json::array({colour, colour})}}));
    }
    return kinds;
}

}  // namespace

Json file_json(const adiabatic::Certificate& certificate, const BoxBudget& budget) {
    const adiabatic::Hypotheses& of = certificate.hypotheses;
    const bool has_heights = of.claim == adiabatic::Claim::bounce || of.claim == adiabatic::Claim::run;
    std::size_t bound_leaves = 0, outside_leaves = 0;  // of all its trees
    const auto add = [&](const adiabatic::Tree& tree) {
        for (const adiabatic::Node& node : tree) {
            bound_leaves += node.split || node.outside ? 0 : 1;
            outside_leaves += node.outside ? 1 : 0;
        }
    };
    add(certificate.tree);
    for (const adiabatic::Class& one : certificate.classes) {
        add(one.tree);
    }
    Json bounds = Json::array();
    for (const Rational& bound : certificate.bounds) {
        bounds.add(shown_above(bound));
    }
    Json attained = Json::array();
    for (const adiabatic::State& state : certificate.attained) {
        attained.add(Json::object({{"u", to_fraction(state.u)},
                                   {"s", to_fraction(state.s)},
                                   {"delta", to_fraction(state.delta)},
                                   {"n", state.n},
                                   {"value", shown_below(state.value)}}));
    }
    return Json::object({{"claim", name(of.claim)},
                         {"bits", certificate.bits},
                         {"delta", range_json(of.delta)},
                         {"heights", has_heights ? range_json(of.heights) : Json()},
                         {"margin", spelled(of.margin)},
                         {"exponent", of.claim == adiabatic::Claim::bounce ? Json(of.exponent) : Json()},
                         {"classes", certificate.classes.size()},
                         {"leaves", Json::object({{"bound", bound_leaves}, {"outside", outside_leaves}})},
                         {"bounds", bounds},
                         {"attained", attained},
                         {"kinds", kinds_json(certificate)},
                         {"tree", tree_of(certificate, budget)}});
}

std::string claim_options(const adiabatic::Certificate& certificate) {
    return adiabatic::claim_options(certificate.hypotheses, certificate.bounds, certificate.attained);
}

}  // namespace dumbbell::page
