#include "adiabatic/prove.hpp"

#include <algorithm>
#include <array>

#include "adiabatic/bounce_leaf.hpp"
#include "adiabatic/classes.hpp"
#include "adiabatic/cover.hpp"
#include "adiabatic/pair_leaf.hpp"
#include "adiabatic/search.hpp"
#include "number/decimal.hpp"

namespace dumbbell::adiabatic {
namespace {

constexpr double room = 1 + 0x1p-18;  ///< of a bound in the file over what its leaves need
constexpr int bound_digits = 5;
constexpr std::array<double, 6> slacks{1.25, 1.5, 1.75, 2.25, 3, 4.5};
constexpr std::size_t class_leaves = 4'000;  ///< of a class at most, before a greater slack is tried
/// The part of the accuracy that the cover itself may lose where the whole cannot be reached.
constexpr double cover_share = 0.25;

Rational bound_of(double value) { return exact(cut_up(exact(value) * exact(room), bound_digits)); }

/// A class with its potential, as the leaves use it.
struct ClassPotential {
    Interval least_share;
    Potential<Interval> potential;
};

ClassPotential potential_of(const Class& one) {
    std::vector<Potential<Interval>::Cell> cells;
    cells.reserve(one.cells.size());
    for (const auto& cell : one.cells) {
        cells.push_back({enclose<Interval>(cell.u), enclose<Interval>(cell.v)});
    }
    return {enclose<Interval>(one.least_share), Potential<Interval>(std::move(cells))};
}

class Prover {
  public:
    explicit Prover(const Request& request)
        : request_(request),
          of_(request.of),
          sides_(request.of),
          accuracy_(request.accuracy.convert_to<double>()) {
        proof_.hypotheses = request.of;
    }

    Proof proof() {
        if (of_.claim == Claim::bounce) {
            prove_bounce();
        } else {
            prove_pairs();
        }
        return std::move(proof_);
    }

  private:
    [[nodiscard]] Limits limits(std::size_t most_leaves = Limits{}.max_leaves) const {
        return {.jobs = request_.jobs,
                .max_leaves = most_leaves,
                .interrupted = request_.interrupted,
                .observer = request_.observer};
    }

    /// The best of the found orbits that can be enclosed; its value, or 0.
    double attain(bool height_error) {
        const Search looked_for{of_, height_error, request_.most_collisions, request_.jobs,
                                request_.interrupted};
        for (const Sample& sample : search_errors(looked_for)) {
            if (const auto state = attained(looked_for, sample)) {
                proof_.attained.push_back(*state);
                return state->value.convert_to<double>();
            }
        }
        return 0;
    }

    [[nodiscard]] Target target(double value) const {
        return {value * (1 + accuracy_ * 0.999), accuracy_ * cover_share, false};
    }
    void include(const Cover& cover, double value) {
        proof_.bounds.push_back(bound_of(cover.bound));
        proof_.coarser = proof_.coarser || cover.bound > value * (1 + accuracy_);
    }

    // Lemma 3.1 and Corollary 3.2.

    [[nodiscard]] Judged judge_bounce(const Box& box, const std::array<double, 2>& scale) const {
        const auto masses = sides_.masses(box);
        const auto u = admitted_angle(sides_.side(box, Axis::u), sides_.margin(masses));
        if (!u) {
            return {true};
        }
        const Bounce<Interval> bounce(*u, sides_.side(box, Axis::s), masses);
        if (sides_.certainly_elsewhere(*u, masses) || certainly_at_most(bounce.forward(), Interval(0))) {
            return {true};
        }
        const Interval k = delta_power(masses.delta, of_.exponent);
        const Interval square = sqr(masses.delta);
        Judged result;
        result.bound = 0;
        const auto next = next_contact(bounce);
        if (next && next->none) {
            return result;  // the statement is about states with a next collision
        }
        if (scale[0] > 0) {
            result.bound = (bounce.speed_error() * sqr(k) / square).hi() * scale[0];
        }
        if (scale[1] > 0) {
            if (!next) {
                return {};
            }
            const Interval error = magnitude(height_error(bounce, *next)) * k / (Interval(2) * square);
            result.bound = std::max(result.bound, error.hi() * scale[1]);
        }
        return result.bound >= 0 ? result : Judged();
    }

    void prove_bounce() {
        const Box root = sides_.root({Axis::u, Axis::s, Axis::delta});
        for (const bool height : {false, true}) {
            const double value = attain(height);
            const auto judge = [&](const Box& box) {
                return judge_bounce(box, {height ? 0.0 : 1.0, height ? 1.0 : 0.0});
            };
            const auto cover = find_cover(root, judge, target(value), limits());
            if (!cover) {
                proof_.bounds.clear();
                return;
            }
            include(*cover, value);
        }
        const std::array<double, 2> scale{1 / proof_.bounds[0].convert_to<double>(),
                                          1 / proof_.bounds[1].convert_to<double>()};
        const auto judge = [&](const Box& box) { return judge_bounce(box, scale); };
        auto cover = find_cover(root, judge, {1 / room * (1 + 0x1p-20), 0, true}, limits());
        if (!cover) {
            proof_.bounds.clear();
            return;
        }
        take(std::move(*cover));
    }

    // Theorems 3.3 and 3.5.

    /// The class with the least slack for which the tree closes.
    void prove_class(const Class& guess) {
        for (const double slack : slacks) {
            Class one = with_slack(guess, slack);
            const ClassPotential at = potential_of(one);
            const auto judge = [&](const Box& box) {
                const auto masses = sides_.masses(box);
                const Verdict verdict =
                    judge_flights(sides_.side(box, Axis::u), sides_.side(box, Axis::sigma), masses,
                                  sides_.margin(masses), at.least_share, at.potential);
                return Judged{verdict.outside, verdict.excess, 0};
            };
            auto cover = find_cover(sides_.root({Axis::u, Axis::sigma, Axis::delta}), judge, {0, 0, true},
                                    limits(of_.has_one_delta() ? class_leaves : 5 * class_leaves));
            if (cover) {
                one.tree = std::move(cover->tree);
                proof_.leaves += cover->leaves;
                proof_.classes.push_back(std::move(one));
                potentials_.push_back(at);
                return;
            }
            if (request_.interrupted()) {
                return;
            }
        }
    }

    [[nodiscard]] Judged judge_pair(const Box& box) const {
        const auto masses = sides_.masses(box);
        const Interval margin = sides_.margin(masses);
        const auto u = admitted_angle(sides_.side(box, Axis::u), margin);
        const auto v = admitted_angle(sides_.side(box, Axis::v), margin);
        if (!u || !v) {
            return {true};
        }
        const bool run = of_.claim == Claim::run;
        if (run && sides_.certainly_elsewhere(*u, masses)) {
            return {true};
        }
        const Pair<Interval> pair(*u, sides_.side(box, Axis::s), *v, masses);
        if (!run && certainly_not_first(pair)) {
            return {true};
        }
        Judged best;
        for (std::size_t i = 0; i < potentials_.size(); ++i) {
            const auto& [share, potential] = potentials_[i];
            const auto error =
                run ? run_error(pair, share, potential) : scattering_error(pair, share, potential);
            if (error && error->hi() < best.bound) {
                best.bound = error->hi();
                best.by_class = static_cast<int>(i);
            }
        }
        return best;
    }

    void prove_pairs() {
        const double value = attain(false);
        for (const Class& guess : guess_classes(of_, request_.jobs, request_.interrupted)) {
            prove_class(guess);
        }
        if (proof_.classes.empty() || request_.interrupted()) {
            return;
        }
        const auto judge = [&](const Box& box) { return judge_pair(box); };
        auto cover =
            find_cover(sides_.root({Axis::u, Axis::s, Axis::v, Axis::delta}), judge, target(value), limits());
        if (cover) {
            include(*cover, value);
            take(std::move(*cover));
        }
    }

    void take(Cover cover) {
        proof_.leaves += cover.leaves;
        proof_.tree = std::move(cover.tree);
    }

    const Request& request_;
    const Hypotheses& of_;
    Sides sides_;
    double accuracy_;
    std::vector<ClassPotential> potentials_;
    Proof proof_;
};

}  // namespace

Proof prove(const Request& request) { return Prover(request).proof(); }

}  // namespace dumbbell::adiabatic
