// Files about the adiabatic invariant for tests: a plain search for real trees asks the verifier's own checks
// what they accept, so it shows that true claims are accepted; that false ones are refused is shown by
// mutating what comes out, and by simulated orbits.
#pragma once
#include <cmath>
#include <functional>

#include "catch.hpp"
#include "rooms/verify/core/make_certificate.hpp"
#include "rooms/verify/wings/starts/make_file.hpp"
#include "verify/wings/adiabatic/grammar.hpp"

namespace make {

namespace adiabatic = dumbbell_verify::adiabatic;

inline std::string level(const mpq_class& x) { return fraction(x); }

struct Adiabatics {
    adiabatic::Terms terms;
    std::vector<std::vector<std::pair<mpq_class, mpq_class>>> cells;  ///< of each class: u, v
    unsigned bits = 53;

    void add_class(const mpq_class& J, const std::vector<std::pair<mpq_class, mpq_class>>& list) {
        dumbbell_verify::adiabatic::Potential potential(mpq_class(11, 7));
        for (const auto& [u, v] : list) potential.add_cell(u, v);
        terms.classes.push_back({J, potential});
        cells.push_back(list);
    }

    [[nodiscard]] adiabatic::Leaf root(adiabatic::Leaf::Part part, std::size_t index) const {
        adiabatic::Leaf leaf;
        leaf.part = part;
        leaf.terms = &terms;
        leaf.index = index;
        leaf.bits = bits;
        leaf.box.hi = {2, 1, 2, terms.claim.delta_hi, 8};
        leaf.box.lo[adiabatic::axis_delta] = terms.claim.delta_lo;
        return leaf;
    }
    /// The axes of a tree, each with a width below which it is not worth halving next to the others.
    using Axes = std::vector<std::pair<std::size_t, double>>;
    [[nodiscard]] std::string class_tree(std::size_t index) const {
        return tree(root(adiabatic::Leaf::class_tree, index),
                    {{adiabatic::axis_u, 1}, {adiabatic::axis_sigma, 4}, {adiabatic::axis_delta, 0.2}});
    }
    [[nodiscard]] std::string claim_tree() const {
        const adiabatic::Leaf leaf = root(adiabatic::Leaf::claim_tree, 0);
        if (terms.claim.kind == adiabatic::Claim::bounce)
            return tree(leaf, {{adiabatic::axis_u, 1}, {adiabatic::axis_s, 1}, {adiabatic::axis_delta, 0.2}});
        return tree(leaf, {{adiabatic::axis_u, 1},
                           {adiabatic::axis_s, 1},
                           {adiabatic::axis_v, 1},
                           {adiabatic::axis_delta, 0.2}});
    }
    /// A tree that proves the claim on the box, or std::runtime_error. It halves the axis whose thinner box
    /// would be longest in these units.
    [[nodiscard]] std::string tree(adiabatic::Leaf leaf, const Axes& axes, int depth = 0) const {
        static constexpr const char* names[] = {"u", "s", "v", "delta", "sigma"};
        // What doubles do not certify of a class is halved: the second attempt is dear, and mostly in vain.
        if (terms.claim.has_classes()) leaf.bits = 2;
        leaf.outside = true;
        if (!dumbbell_verify::adiabatic::check_leaf(leaf, nullptr)) return "outside\n";
        leaf.outside = false;
        const bool chooses = leaf.part == adiabatic::Leaf::claim_tree && terms.claim.has_classes();
        for (std::size_t i = 0; i < (chooses ? terms.classes.size() : 1); ++i) {
            if (chooses) leaf.index = i;
            if (!dumbbell_verify::adiabatic::check_leaf(leaf, nullptr))
                return chooses ? "bound " + std::to_string(i) + "\n" : "bound\n";
        }
        if (depth > 40) {
            dumbbell_verify::Log log;
            leaf.outside = false;
            dumbbell_verify::adiabatic::check_leaf(leaf, &log);
            std::string& text = log.text;
            for (const auto& [axis, unit] : axes)
                text += std::string(names[axis]) + " " + std::to_string(leaf.box.lo[axis].get_d()) + "\n";
            throw std::runtime_error("the cover does not close:\n" + text);
        }
        std::size_t longest = adiabatic::axis_u;
        double most = 0;
        for (const auto& [axis, unit] : axes) {
            const mpq_class &lo = leaf.box.lo.at(axis), &hi = leaf.box.hi.at(axis);
            const bool relative = axis == adiabatic::axis_u || axis == adiabatic::axis_v;
            const double length = mpq_class((hi - lo) / (relative ? hi : mpq_class(1))).get_d() / unit;
            if (length > most) most = length, longest = axis;
        }
        const mpq_class middle = (leaf.box.lo[longest] + leaf.box.hi[longest]) / 2;
        adiabatic::Leaf lower = leaf, upper = leaf;
        lower.box.hi[longest] = upper.box.lo[longest] = middle;
        return "split " + std::string(names[longest]) + "\n" + tree(lower, axes, depth + 1) +
               tree(upper, axes, depth + 1);
    }

    [[nodiscard]] std::string header() const {
        const adiabatic::Claim& claim = terms.claim;
        std::string text =
            "dumbbell-certificate 1\ngenerator test 1.0\nlemmas 1\nscene dumbbell\nsection none\nclaim " +
            std::string(adiabatic::Claim::names.at(claim.kind)) + "\ndelta " + level(claim.delta_lo) + " " +
            level(claim.delta_hi) + "\n";
        if (claim.has_heights()) text += "heights " + level(claim.y_lo) + " " + level(claim.y_hi) + "\n";
        text += "margin " + level(claim.margin) + "\n";
        if (claim.kind == adiabatic::Claim::bounce)
            text += "exponent " + std::to_string(claim.exponent) + "\n";
        text += "bits " + std::to_string(bits) + "\n";
        text += "bound";
        for (const mpq_class& bound : claim.bounds) text += " " + level(bound);
        return text + "\n";
    }
    [[nodiscard]] std::string class_lines(std::size_t i) const {
        std::string text =
            "class " + level(terms.classes.at(i).J) + " " + std::to_string(cells[i].size()) + "\n";
        for (const auto& [u, v] : cells[i]) text += "cell " + level(u) + " " + level(v) + "\n";
        return text;
    }
    [[nodiscard]] std::string attained_lines() const {
        std::string text;
        for (const adiabatic::Claim::Attained& a : terms.claim.attained)
            text += "attained " + level(a.u) + " " + level(a.s) + " " + level(a.delta) + " " +
                    std::to_string(a.collisions) + " " + level(a.value) + "\n";
        return text;
    }
    /// The whole file, trees found by search.
    [[nodiscard]] std::string file() const {
        std::string text = header();
        if (terms.claim.has_classes()) {
            text += "classes " + std::to_string(terms.classes.size()) + "\n";
            for (std::size_t i = 0; i < terms.classes.size(); ++i) text += class_lines(i) + class_tree(i);
            text += "end\n";
        }
        return closed(text + claim_tree() + attained_lines());
    }
};

/// Cells of equal ratio of u from 11/7 down to `low`, with `factor` times what flat flights need, and what
/// steep ones need besides.
inline std::vector<std::pair<mpq_class, mpq_class>> cells_down_to(const mpq_class& low, int n, double factor,
                                                                  double steep) {
    std::vector<std::pair<mpq_class, mpq_class>> list;
    const double ratio = std::pow(low.get_d() * 7 / 11, 1.0 / n);
    double u = 11.0 / 7;
    for (int i = 1; i <= n; ++i) {
        u *= ratio;
        const mpq_class edge = i == n ? low : mpq_class(std::lround(u * 65536), 65536);
        const double w = std::sin(edge.get_d()), f = M_PI - edge.get_d(), s = std::cos(edge.get_d());
        mpq_class v(std::lround(16 * (factor * (2 * f * s / (w * w * w) + 1 / (w * w)) +
                                      steep * f * f / (w * w * w * w))),
                    16);
        mpq_class canonical = edge;
        canonical.canonicalize();
        v.canonicalize();
        list.emplace_back(canonical, v);
    }
    return list;
}

/// At delta = 1/20, where the states of adiabatic_claims_test attain the values.
inline Adiabatics small_claim(adiabatic::Claim::Kind kind) {
    Adiabatics file;
    adiabatic::Claim& claim = file.terms.claim;
    claim.kind = kind;
    claim.delta_lo = claim.delta_hi = mpq_class(1, 20);
    claim.y_lo = mpq_class(3, 5);
    claim.y_hi = mpq_class(9, 10);
    claim.margin = 1;
    claim.exponent = kind == adiabatic::Claim::run ? 0 : 8;
    return file;
}
inline Adiabatics small_bounce() {
    Adiabatics file = small_claim(adiabatic::Claim::bounce);
    adiabatic::Claim& claim = file.terms.claim;
    claim.y_hi = 1;
    claim.bounds = {mpq_class(5, 2), mpq_class(10)};
    claim.attained = {{mpq_class(1119, 5000), 1, mpq_class(1, 20), 1, mpq_class(194, 100)},
                      {mpq_class(1119, 5000), 1, mpq_class(1, 20), 1, mpq_class(857, 100)}};
    for (auto& state : claim.attained) state.value.canonicalize();
    return file;
}
inline Adiabatics small_run() {
    Adiabatics file = small_claim(adiabatic::Claim::run);
    adiabatic::Claim& claim = file.terms.claim;
    claim.margin = mpq_class(1, 2);
    claim.bounds = {mpq_class(20)};
    claim.attained = {{mpq_class(63, 125), mpq_class(97, 100), mpq_class(1, 20), 10, mpq_class(93, 10)}};
    file.add_class(mpq_class(13, 10), cells_down_to(mpq_class(511, 1024), 40, 1.3, 2));
    return file;
}
inline Adiabatics small_scattering() {
    Adiabatics file = small_claim(adiabatic::Claim::scattering);
    adiabatic::Claim& claim = file.terms.claim;
    claim.delta_lo = claim.delta_hi = mpq_class(1, 10000);
    claim.bounds = {mpq_class(60)};
    claim.attained = {{mpq_class(1, 100), 1, mpq_class(1, 10000), 4431, mpq_class(69, 20)}};
    file.add_class(mpq_class(19, 10), cells_down_to(mpq_class(37, 4096), 300, 1.3, 5));
    return file;
}

/// The whole files of these claims; each is searched for once.
inline const std::string& bounce() {
    static const std::string text = small_bounce().file();
    return text;
}
inline const std::string& run_file() {
    static const std::string text = small_run().file();
    return text;
}
inline const std::string& scattering() {
    static const std::string text = small_scattering().file();
    return text;
}

/// What the verifier says of such a file with `from` replaced.
inline std::string mutant(const std::string& text, const std::string& from, const std::string& to) {
    INFO(from << " -> " << to);
    return outcome(mutated(text, from, to));
}

}  // namespace make
