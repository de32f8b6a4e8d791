#include "starts/answer/mean.hpp"

#include <fmt/core.h>

#include "base/error.hpp"
#include "number/decimal.hpp"
#include "number/flint.hpp"

namespace dumbbell::starts {
namespace {

constexpr int mean_digits = 12;

/// E(m)/pi, E the complete elliptic integral of the second kind, for m < 0. It is more than E(0)/pi = 1/2.
BigInterval share_of_arc(const Rational& m) {
    const slong bits = PrecisionScope::current() + 20;
    const BigInterval parameter = enclose<BigInterval>(m);
    acb_t value;
    arb_t half_turn;
    acb_init(value);
    arb_init(half_turn);
    arb_set_interval_arf(acb_realref(value), parameter.lower(), parameter.upper(), bits);
    acb_elliptic_e(value, value, bits);
    arb_const_pi(half_turn, bits);
    arb_div(acb_realref(value), acb_realref(value), half_turn, bits);
    BigInterval result;
    arb_get_interval_arf(result.lower(), result.upper(), acb_realref(value), PrecisionScope::current());
    acb_clear(value);
    arb_clear(half_turn);
    flint_cleanup();
    return max(result, BigInterval(0.5));
}

std::pair<MeanBounds, ExactMean> both_means(const Box& all, const PackedTree& tree) {
    const MeanBounds bounds = mean_bounds(tree);
    const ExactMean exact = exact_mean(all.lower(Axis::ratio), all.rho);
    require(bounds.lo <= exact_hi(exact.all) && (!bounds.hi || exact_lo(exact.all) <= *bounds.hi),
            "the mean number of collisions is not that of the theorem");
    return {bounds, exact};
}

std::string digits_of_mean(const BigInterval& x) {
    const auto shared = shared_digits(exact_lo(x), exact_hi(x), mean_digits);
    require(shared.has_value(), "a mean was not enclosed to the digits that are shown");
    return to_text(*shared);
}

}  // namespace

ExactMean exact_mean(const Rational& q, const std::optional<Rational>& rho) {
    const BigInterval heavy = share_of_arc(rho ? Rational(-q * *rho * *rho) : Rational(-1) / q);
    return {share_of_arc(-q) + heavy, heavy};
}

std::string mean_text(const Box& all, const PackedTree& tree) {
    const auto [bounds, exact] = both_means(all, tree);
    const std::string least = bounds.lo == 0 ? "0" : to_text(cut_down(bounds.lo, mean_digits));
    const std::string by_boxes =
        bounds.hi ? fmt::format("between {} and {}", least, to_text(cut_up(*bounds.hi, mean_digits)))
                  : fmt::format("at least {}", least);
    const char* formulas =
        all.rho ? "(E(-Q) + E(-Q rho^2))/pi, of which the heavy end has\n{}... = E(-Q rho^2)/pi (L85 of "
                  "proofs/body.md)"
                : "(E(-q) + E(-1/q))/pi, and the heavy mass hits the floor with\nprobability {}... = "
                  "E(-1/q)/pi (theorem 6 of proofs/theorem.md)";
    return fmt::format("Their mean number of collisions is {}... = {}. By the boxes the mean is {}.\n",
                       digits_of_mean(exact.all),
                       fmt::format(fmt::runtime(formulas), digits_of_mean(exact.heavy)), by_boxes);
}

Json mean_json(const Box& all, const PackedTree& tree) {
    const auto [bounds, exact] = both_means(all, tree);
    const auto ends = [](const BigInterval& x) { return ends_json(Interval(x.lo(), x.hi())); };
    return Json::object({{"lo", to_fraction(bounds.lo)},
                         {"hi", bounds.hi ? Json(to_fraction(*bounds.hi)) : Json()},
                         {"exact", ends(exact.all)},
                         {"heavy", ends(exact.heavy)}});
}

}  // namespace dumbbell::starts
