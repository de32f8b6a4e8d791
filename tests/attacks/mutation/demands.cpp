#include "demands.hpp"

#include <optional>
#include <set>

#include "adiabatic/writer.hpp"

namespace dumbbell_mutation {
namespace {

using dumbbell::Rational;
using dumbbell::collisions::Piece;

mpq_class exact(const Rational& x) { return mpq_class(dumbbell::to_fraction(x)); }

struct Bounds {
    std::optional<long> most, least;
    [[nodiscard]] std::string text() const {
        if (most && most == least) return " --exactly " + std::to_string(*most);
        return (most ? " --max " + std::to_string(*most) : "") +
               (least ? " --min " + std::to_string(*least) : "");
    }
};

/// Do pieces with this property cover [lo, hi]? Each begins where the one before ends.
template <class Property>
bool cover(const std::vector<Piece>& pieces, const Rational& lo, const Rational& hi, Property property) {
    std::optional<Rational> reached;
    for (const Piece& piece : pieces)
        if (property(piece) && piece.q_lo <= (reached ? *reached : lo) &&
            piece.q_hi >= (reached ? *reached : lo))
            reached = piece.q_hi;
    return reached && *reached >= hi;
}

bool proves(const std::vector<Piece>& pieces, const Rational& lo, const Rational& hi, const Bounds& bounds) {
    return cover(pieces, lo, hi, [](const Piece&) { return true; }) &&
           (!bounds.most ||
            cover(pieces, lo, hi, [&](const Piece& p) { return p.upper && *p.upper <= *bounds.most; })) &&
           (!bounds.least || cover(pieces, lo, hi, [&](const Piece& p) { return p.lower >= *bounds.least; }));
}

std::vector<Bounds> bounds_near(const std::set<long>& numbers) {
    std::vector<Bounds> all = {{}};
    for (const long n : numbers) {
        all.push_back({n, std::nullopt});
        all.push_back({std::nullopt, n});
        all.push_back({n, n});
    }
    return all;
}

void with_one_more_and_less(std::set<long>& numbers, long n) {
    numbers.insert({std::max(0L, n - 1), n, n + 1});
}

dumbbell_verify::Request settings_of(const Rational& lo, const Rational& hi, const Bounds& bounds,
                                     const std::string& scene) {
    dumbbell_verify::Request settings;
    settings.scene = scene;
    settings.demand.ratios = std::pair(exact(lo), exact(hi));
    if (bounds.most) settings.demand.most = static_cast<std::uint64_t>(*bounds.most);
    if (bounds.least) settings.demand.least = static_cast<std::uint64_t>(*bounds.least);
    return settings;
}

std::vector<Demand> demands_of(const dumbbell::collisions::Certificate& data) {
    std::set<long> numbers;
    std::set<Rational> ends = {data.q_lo() / 2 + Rational(1, 2), data.q_hi() * 2};
    for (const Piece& piece : data.pieces) {
        if (piece.upper) with_one_more_and_less(numbers, as_long(*piece.upper));
        with_one_more_and_less(numbers, as_long(piece.lower));
        ends.insert({piece.q_lo, piece.q_hi, (piece.q_lo + piece.q_hi) / 2});
    }
    const auto rhos = [&](Demand& demand, const Rational& lo, const Rational& hi) {
        demand.settings.demand.rhos = std::pair(exact(lo), exact(hi));
        demand.what += " --rho " + dumbbell::to_fraction(lo) + ":" + dumbbell::to_fraction(hi);
    };
    std::vector<Demand> demands;
    for (const Rational& lo : ends)
        for (const Rational& hi : ends)
            for (const Bounds& bounds : bounds_near(numbers)) {
                if (lo > hi) continue;
                const std::string range =
                    " " + dumbbell::to_fraction(lo) + ":" + dumbbell::to_fraction(hi) + bounds.text();
                const bool proved = proves(data.pieces, lo, hi, bounds);
                for (const bool wider : {false, true}) {
                    demands.push_back({settings_of(lo, hi, bounds, "body"), "--inertia" + range,
                                       proved && data.system.rho && !wider});
                    const Rational rho = data.system.rho.value_or(1);
                    rhos(demands.back(), wider ? rho * Rational(9, 10) : rho, rho);
                }
                demands.push_back({settings_of(lo, hi, bounds, "dumbbell"),
                                   "--ratio" + range + " --scene dumbbell", proved && !data.system.rho});
                if (data.system.rho) continue;  // with --claim initial-conditions --inertia is wrong usage
                demands.push_back({settings_of(lo, hi, bounds, "dumbbell"),
                                   "--ratio" + range + " --scene dumbbell --claim initial-conditions",
                                   false});
                demands.back().settings.claim = "initial-conditions";
            }
    return demands;
}

std::vector<Demand> demands_of(const dumbbell::starts::Certificate& data) {
    long least = LONG_MAX, most = 0;
    bool all = true;
    for (const dumbbell::starts::Node& node : data.tree) {
        if (node.split) continue;
        all = all && node.leaf.most;
        least = std::min(least, node.leaf.least);
        most = std::max(most, node.leaf.most.value_or(0));
    }
    if (!all) least = 0;
    std::set<long> numbers;
    with_one_more_and_less(numbers, least);
    with_one_more_and_less(numbers, most);
    const Rational from = data.box.lo.back(), to = data.box.hi.back();
    const std::string kind = data.incoming ? "incoming" : "initial-conditions";
    std::vector<Demand> demands;
    for (const auto& [lo, hi] :
         {std::pair(from, to), {(from + to) / 2, to}, {from, to * 2}, {from / 2 + Rational(1, 2), to}})
        for (const Bounds& bounds : bounds_near(numbers)) {
            const std::string what =
                "--ratio " + dumbbell::to_fraction(lo) + ":" + dumbbell::to_fraction(hi) + bounds.text();
            const bool proved = from <= lo && hi <= to && (!bounds.most || (all && most <= *bounds.most)) &&
                                (!bounds.least || least >= *bounds.least);
            demands.push_back({settings_of(lo, hi, bounds, "dumbbell"), what, false, false});
            demands.push_back({settings_of(lo, hi, bounds, "dumbbell"), what + " --claim " + kind, proved});
            demands.back().settings.claim = kind;
        }
    return demands;
}

std::vector<Demand> demands_of(const dumbbell::adiabatic::Certificate& data) {
    std::vector<Demand> demands;
    for (const std::string scene : {"dumbbell", "body"})
        for (const std::string claim : {"", "adiabatic-bounce", "adiabatic-run", "adiabatic-scattering",
                                        "initial-conditions", "collisions"}) {
            dumbbell_verify::Request settings;
            settings.scene = scene;
            settings.claim = claim;
            const bool proved =
                scene == "dumbbell" && (claim.empty() || claim == name(data.hypotheses.claim));
            demands.push_back(
                {settings, "--scene " + scene + (claim.empty() ? "" : " --claim " + claim), proved});
        }
    for (const Bounds& bounds : bounds_near({0, 1, 2}))
        demands.push_back(
            {settings_of(1, 400, bounds, "dumbbell"), "--ratio 1:400" + bounds.text(), false, false});
    return demands;
}

}  // namespace

std::vector<Demand> demands_of(const Base& base) {
    return std::visit([](const auto& data) { return demands_of(data); }, base.data);
}

}  // namespace dumbbell_mutation
