#include <fmt/format.h>

#include "arith/decimal.hpp"
#include "certificate/adiabatic_writer.hpp"
#include "report/html_file.hpp"
#include "report/html_tree.hpp"

namespace dumbbell {
namespace {

using Json = nlohmann::ordered_json;

/// Of C, B and their like: rounded to nearest for reading; the file has them exactly.
constexpr int shown_digits = 6;

std::string shown(const Rational& x) {
    return x < 0 ? "-" + to_decimal(-x, shown_digits) : to_decimal(x, shown_digits);
}

Json range_json(const std::pair<Rational, Rational>& range) {
    return {shown(range.first), shown(range.second)};
}

/// Leaves of all its trees by word.
struct Leaves {
    std::size_t bound = 0;
    std::size_t outside = 0;

    void add(const AdiabaticTree& tree) {
        for (const AdiabaticNode& node : tree) {
            if (!node.split) {
                ++(node.outside ? outside : bound);
            }
        }
    }
};

Json tree_of(const AdiabaticCertificate& certificate, const BoxBudget& budget) {
    PictureTree tree;
    for (const AdiabaticNode& node : certificate.tree) {
        tree.push_back(node.split     ? split_of(static_cast<std::size_t>(*node.split))
                       : node.outside ? 0
                                      : 1 + node.by_class);
    }
    Json json = tree_json(tree, share_of(leaves_of(tree), budget.total, budget.most));
    const auto& [lo, hi] = certificate.hypotheses.delta;
    json["axes"] = Json::array({{{"name", "u"}, {"lo", "0/1"}, {"hi", "2/1"}},
                                {{"name", "sigma"}, {"lo", "0/1"}, {"hi", "0/1"}},
                                {{"name", "s"}, {"lo", "0/1"}, {"hi", "1/1"}},
                                {{"name", "v"}, {"lo", "0/1"}, {"hi", "2/1"}},
                                {{"name", "delta"}, {"lo", to_fraction(lo)}, {"hi", to_fraction(hi)}}});
    return json;
}

Json kinds_json(const AdiabaticCertificate& certificate) {
    Json kinds = Json::array({{{"reason", "outside"}}});
    const std::size_t classes = std::max<std::size_t>(1, certificate.classes.size());
    for (std::size_t i = 0; i < classes; ++i) {
        kinds.push_back({{"reason", "bound"}, {"class", i}});
    }
    return kinds;
}

}  // namespace

nlohmann::ordered_json file_json(const AdiabaticCertificate& certificate, const BoxBudget& budget) {
    const AdiabaticHypotheses& of = certificate.hypotheses;
    const bool has_heights = of.claim == AdiabaticClaim::bounce || of.claim == AdiabaticClaim::run;
    Leaves leaves;
    leaves.add(certificate.tree);
    for (const AdiabaticClass& one : certificate.classes) {
        leaves.add(one.tree);
    }
    Json json{{"claim", name(of.claim)},
              {"lemmas", "1"},
              {"bits", certificate.bits},
              {"delta", range_json(of.delta)},
              {"heights", has_heights ? range_json(of.heights) : Json(nullptr)},
              {"margin", shown(of.margin)},
              {"exponent", of.claim == AdiabaticClaim::bounce ? Json(of.exponent) : Json(nullptr)},
              {"classes", certificate.classes.size()},
              {"leaves", {{"bound", leaves.bound}, {"outside", leaves.outside}}},
              {"bounds", Json::array()},
              {"attained", Json::array()},
              {"kinds", kinds_json(certificate)},
              {"tree", nullptr}};
    for (const Rational& bound : certificate.bounds) {
        json["bounds"].push_back(shown(bound));
    }
    for (const AdiabaticState& state : certificate.attained) {
        json["attained"].push_back({{"u", to_fraction(state.u)},
                                    {"s", to_fraction(state.s)},
                                    {"delta", to_fraction(state.delta)},
                                    {"n", state.n},
                                    {"value", shown(state.value)}});
    }
    if (!certificate.tree.empty()) {
        json["tree"] = tree_of(certificate, budget);
    }
    return json;
}

std::string claim_options(const AdiabaticCertificate& certificate) {
    return fmt::format("--claim {}", name(certificate.hypotheses.claim));
}

}  // namespace dumbbell
