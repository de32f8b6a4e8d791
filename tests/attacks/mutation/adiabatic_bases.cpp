#include <algorithm>

#include "adiabatic/classes.hpp"
#include "adiabatic/search.hpp"
#include "adiabatic/writer.hpp"
#include "adiabatic_judge.hpp"
#include "base/error.hpp"
#include "bases.hpp"

namespace dumbbell_mutation {
namespace {

using namespace dumbbell;
using namespace dumbbell::adiabatic;
using Found = AdiabaticJudge::Found;

constexpr double density_slack = 3;  ///< so that few boxes are needed
constexpr int most_depth = 24;

/// A tree that `judge` closes: from a box to a leaf, or nothing. It halves the axis that is longest next to
/// its root.
template <class Judge>
void grow(const AdiabaticSet& root, const AdiabaticSet& box, int depth, const Judge& judge,
          adiabatic::Tree& tree) {
    if (const auto leaf = judge(box)) {
        tree.push_back(*leaf);
        return;
    }
    require(depth < most_depth, "the tree of a base does not close");
    std::size_t longest = 0;
    double most = 0;
    for (std::size_t i = 0; i < adiabatic::axis_count; ++i) {
        if (root.lo[i] == root.hi[i]) continue;
        // u and v: relative, since what happens there depends on 1/u.
        const bool angle = i == static_cast<std::size_t>(adiabatic::Axis::u) ||
                           i == static_cast<std::size_t>(adiabatic::Axis::v);
        const Rational unit = angle ? Rational(2 * box.hi[i]) : Rational(root.hi[i] - root.lo[i]);
        const double length = Rational((box.hi[i] - box.lo[i]) / unit).convert_to<double>();
        if (length > most) {
            most = length;
            longest = i;
        }
    }
    const auto axis = static_cast<adiabatic::Axis>(longest);
    const auto [lower, upper] = box.halves(axis);
    tree.push_back({axis, false, 0});
    grow(root, lower, depth + 1, judge, tree);
    grow(root, upper, depth + 1, judge, tree);
}

/// Of an orbit, as in adiabatic::Sample.
struct Start {
    double u, s, share;
};

/// Trees for a certificate that has all but these, and what these orbits attain.
Base grown(const std::string& name, std::size_t cost, adiabatic::Certificate data,
           std::initializer_list<Start> orbits) {
    const adiabatic::Claim claim = data.hypotheses.claim;
    const AdiabaticJudge judge(data);
    const auto leaf_of = [](Found found, int by_class) -> std::optional<adiabatic::Node> {
        if (found == Found::nothing) return std::nullopt;
        return adiabatic::Node{std::nullopt, found == Found::outside, found == Found::outside ? 0 : by_class};
    };
    const AdiabaticSet of_class = judge.root(class_axes()), of_claim = judge.root(claim_axes(claim));
    for (std::size_t i = 0; i < data.classes.size(); ++i)
        grow(
            of_class, of_class, 0,
            [&](const AdiabaticSet& box) { return leaf_of(judge.of_class(i, box), 0); },
            data.classes[i].tree);
    const auto of_some_class = [&](const AdiabaticSet& box) {
        std::optional<adiabatic::Node> leaf;
        for (std::size_t i = 0; i < std::max<std::size_t>(1, data.classes.size()) && !leaf; ++i)
            leaf = leaf_of(judge.of_claim(i, box), static_cast<int>(i));
        return leaf;
    };
    grow(of_claim, of_claim, 0, of_some_class, data.tree);
    for (const Start& start : orbits) {
        adiabatic::Search search;
        search.of = data.hypotheses;
        search.height_error = data.attained.size() == 1;
        const auto state = attained(search, simulated(search, start.u, start.s, start.share));
        require(state.has_value(), "the orbit of a base is not enclosed");
        data.attained.push_back(*state);
    }
    std::string text = render(data).text;
    return {name, std::move(data), std::move(text), cost};
}

adiabatic::Hypotheses hypotheses(adiabatic::Claim claim, const char* from, const char* to,
                                 const char* margin) {
    adiabatic::Hypotheses of;
    of.claim = claim;
    of.delta = {parse_rational(from), parse_rational(to)};
    of.margin = parse_rational(margin);
    return of;
}
adiabatic::Hypotheses with_heights(adiabatic::Hypotheses of, const char* from, const char* to) {
    of.heights = {parse_rational(from), parse_rational(to)};
    return of;
}
adiabatic::Certificate certificate(const adiabatic::Hypotheses& of, std::vector<Rational> bounds,
                                   const std::vector<std::size_t>& classes = {}) {
    adiabatic::Certificate result{{"mutation", "1.0"}, of, 53, std::move(bounds), {}, {}, {}};
    const auto guessed = classes.empty() ? std::vector<adiabatic::Class>{} : guess_classes(of);
    for (const std::size_t i : classes) result.classes.push_back(with_slack(guessed.at(i), density_slack));
    return result;
}

}  // namespace

std::vector<Base> adiabatic_bases() {
    const adiabatic::Hypotheses bounce =
        with_heights(hypotheses(adiabatic::Claim::bounce, "1/25", "1/20", "1"), "3/5", "9/10");
    const adiabatic::Hypotheses run =
        with_heights(hypotheses(adiabatic::Claim::run, "1/20", "1/20", "1"), "3/10", "1/2");
    const adiabatic::Hypotheses scattering = hypotheses(adiabatic::Claim::scattering, "1/100", "1/100", "1");
    std::vector<Base> all;
    all.push_back(
        grown("bounce", 8, certificate(bounce, {Rational(3, 5), 6}), {{0.446, 0, 1}, {0.446, 1, 1}}));
    all.push_back(grown("run", 12, certificate(run, {10}, {0, 2}), {{1.0508, 0.958, 0}}));
    all.push_back(grown("scattering", 32, certificate(scattering, {40}, {0}), {{0.3, 1, 0}}));
    return all;
}

}  // namespace dumbbell_mutation
