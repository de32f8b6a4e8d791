#include "adiabatic_argument.hpp"

#include <fmt/format.h>

#include <array>

#include "adiabatic/reader.hpp"
#include "adiabatic/writer.hpp"
#include "adiabatic_judge.hpp"
#include "base/error.hpp"

namespace dumbbell_mutation {
namespace {

using namespace dumbbell;
using namespace dumbbell::adiabatic;
using Found = AdiabaticJudge::Found;

/// Something that could not be shown.
struct NotShown {
    std::string what;
};

std::string text(const Rational& x) { return to_fraction(x); }
std::string text(const mpq_class& x) { return dumbbell_verify::to_string(x); }

/// Every number of a claim, in the order of the file.
template <class Number>
std::string numbers(std::initializer_list<Number> all) {
    std::string line;
    for (const Number& x : all) line += " " + text(x);
    return line;
}
std::string claim_of(const adiabatic::Certificate& c) {
    const adiabatic::Hypotheses& of = c.hypotheses;
    const bool heights = of.claim == adiabatic::Claim::bounce || of.claim == adiabatic::Claim::run;
    std::string line = std::string(name(of.claim)) + numbers({of.delta.first, of.delta.second, of.margin});
    if (heights) line += numbers({of.heights.first, of.heights.second});
    if (of.claim == adiabatic::Claim::bounce) line += " " + std::to_string(of.exponent);
    for (const Rational& bound : c.bounds) line += numbers({bound});
    for (const adiabatic::State& a : c.attained)
        line += numbers({a.u, a.s, a.delta, a.value}) + " " + std::to_string(a.n);
    return line;
}
std::string claim_of(const dumbbell_verify::adiabatic::Claim& c) {
    std::string line = std::string(dumbbell_verify::adiabatic::Claim::names.at(c.kind)) +
                       numbers({c.delta_lo, c.delta_hi, c.margin});
    if (c.has_heights()) line += numbers({c.y_lo, c.y_hi});
    if (c.kind == dumbbell_verify::adiabatic::Claim::bounce) line += " " + std::to_string(c.exponent);
    for (const mpq_class& bound : c.bounds) line += numbers({bound});
    for (const auto& a : c.attained)
        line += numbers({a.u, a.s, a.delta, a.value}) + " " + std::to_string(a.collisions);
    return line;
}

/// Where the statements and the formulas that are used here are about nothing else.
void require_sensible_numbers(const adiabatic::Certificate& c) {
    const auto& [from, to] = c.hypotheses.delta;
    const bool run = c.hypotheses.claim == adiabatic::Claim::run;
    if (from > to || to <= 0 || 2 * to >= 1 || from < 0 || (from == 0 && !run)) throw NotShown{"delta"};
    if (c.hypotheses.margin <= 0) throw NotShown{"margin"};
    for (const adiabatic::Class& one : c.classes) {
        if (!certainly_less(Interval(4) * sqr(pi<Interval>()),
                            Interval(65) * sqr(enclose<Interval>(one.least_share))))
            throw NotShown{"J of a class"};
        Rational top(11, 7);
        if (one.cells.empty()) throw NotShown{"a class without cells"};
        for (const auto& cell : one.cells) {
            if (cell.u >= top || cell.u < 0 || cell.v < 0) throw NotShown{"the cells of a class"};
            top = cell.u;
        }
    }
}

class Trees {
  public:
    explicit Trees(const adiabatic::Certificate& certificate)
        : certificate_(certificate), judge_(certificate) {}

    void check() {
        for (std::size_t i = 0; i < certificate_.classes.size(); ++i)
            tree(certificate_.classes[i].tree, class_axes(), fmt::format("class {}", i),
                 [&](int /*unused*/, const AdiabaticSet& box) { return judge_.of_class(i, box); });
        if (!certificate_.bounds.empty())
            tree(certificate_.tree, claim_axes(certificate_.hypotheses.claim), "the claim",
                 [&](int by_class, const AdiabaticSet& box) {
                     return judge_.of_claim(static_cast<std::size_t>(by_class), box);
                 });
        for (std::size_t i = 0; i < certificate_.attained.size(); ++i)
            if (!judge_.attained(i)) throw NotShown{fmt::format("the attained state {}", i + 1)};
    }
    [[nodiscard]] std::size_t leaves() const { return leaves_; }

  private:
    template <class Judge>
    void tree(const adiabatic::Tree& nodes, const std::vector<adiabatic::Axis>& axes, const std::string& of,
              const Judge& judge) {
        std::size_t next = 0;
        walk(nodes, next, judge_.root(axes), of, judge);
        if (next != nodes.size()) throw NotShown{of + ": nodes behind the tree"};
    }
    template <class Judge>
    void walk(const adiabatic::Tree& nodes, std::size_t& next, const AdiabaticSet& box, const std::string& of,
              const Judge& judge) {
        const std::size_t here = next++;
        const adiabatic::Node& node = nodes.at(here);
        if (node.split) {
            const auto [lower, upper] = box.halves(*node.split);
            walk(nodes, next, lower, of, judge);
            walk(nodes, next, upper, of, judge);
            return;
        }
        ++leaves_;
        const auto said = [&](const AdiabaticSet& part) { return judge(node.by_class, part); };
        if (!confirmed(box, node.outside, said, most_halvings))
            throw NotShown{fmt::format("{}, node {}: {}", of, here + 1, node.outside ? "outside" : "bound")};
    }
    /// By the prover's formulas on the box, or on the parts of it: what holds for all parts holds for the
    /// box.
    template <class Said>
    bool confirmed(const AdiabaticSet& box, bool outside, const Said& said, int depth) {
        const Found found = said(box);
        if (found == Found::outside || (!outside && found == Found::bound)) return true;
        if (depth == 0) return false;
        std::size_t widest = 0;
        for (std::size_t i = 1; i < adiabatic::axis_count; ++i)
            if (box.hi[i] - box.lo[i] > box.hi[widest] - box.lo[widest]) widest = i;
        if (box.lo[widest] == box.hi[widest]) return false;
        const auto [lower, upper] = box.halves(static_cast<adiabatic::Axis>(widest));
        return confirmed(lower, outside, said, depth - 1) && confirmed(upper, outside, said, depth - 1);
    }

    static constexpr int most_halvings = 12;
    const adiabatic::Certificate& certificate_;
    AdiabaticJudge judge_;
    std::size_t leaves_ = 0;
};

}  // namespace

Argument adiabatic_argument(const std::string& path, const dumbbell_verify::adiabatic::Claim* proved) {
    try {
        const adiabatic::Certificate certificate = adiabatic::read_certificate(path);
        if (proved && claim_of(certificate) != claim_of(*proved))
            throw NotShown{"the verdict states another claim than the file"};
        require_sensible_numbers(certificate);
        Trees trees(certificate);
        trees.check();
        return {true, fmt::format("{} leaves and all attained states judged again by the prover's formulas",
                                  trees.leaves())};
    } catch (const NotShown& fault) {
        return {false, fault.what};
    } catch (const std::exception& error) {
        return {false, error.what()};
    }
}

}  // namespace dumbbell_mutation
