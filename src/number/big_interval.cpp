#include "number/big_interval.hpp"

#include <limits>

#include "base/error.hpp"
#include "number/flint.hpp"

namespace dumbbell {
namespace {

thread_local int working_bits = 128;

constexpr arf_rnd_t down = ARF_RND_FLOOR;
constexpr arf_rnd_t up = ARF_RND_CEIL;

bool is_nan(const BigInterval& x) { return arf_is_nan(x.lower()) != 0 || arf_is_nan(x.upper()) != 0; }

/// Makes both ends NaN if one is.
void spread_nan(BigInterval& x) {
    if (is_nan(x)) {
        arf_nan(x.lower());
        arf_nan(x.upper());
    }
}

bool is_at_least_0(arf_srcptr x) { return arf_sgn(x) >= 0; }
bool is_at_most_0(arf_srcptr x) { return arf_sgn(x) <= 0; }

/// x y, and 0 where one of them is: an infinite bound stands for numbers of any size.
void multiply(arf_ptr to, arf_srcptr x, arf_srcptr y, arf_rnd_t rounding) {
    if (arf_is_zero(x) != 0 || arf_is_zero(y) != 0) {
        arf_zero(to);
    } else {
        arf_mul(to, x, y, working_bits, rounding);
    }
}

}  // namespace

BigInterval::~BigInterval() {
    arf_clear(lo_);
    arf_clear(hi_);
}

PrecisionScope::PrecisionScope(int bits) : previous_(working_bits) {
    require(bits >= 2 && bits <= (1 << 20), "working precision out of range");
    working_bits = bits;
}
PrecisionScope::~PrecisionScope() { working_bits = previous_; }
int PrecisionScope::current() noexcept { return working_bits; }

BigInterval operator+(const BigInterval& a, const BigInterval& b) {
    BigInterval result;
    arf_add(result.lower(), a.lower(), b.lower(), working_bits, down);
    arf_add(result.upper(), a.upper(), b.upper(), working_bits, up);
    spread_nan(result);
    return result;
}
BigInterval operator-(const BigInterval& a, const BigInterval& b) {
    BigInterval result;
    arf_sub(result.lower(), a.lower(), b.upper(), working_bits, down);
    arf_sub(result.upper(), a.upper(), b.lower(), working_bits, up);
    spread_nan(result);
    return result;
}
BigInterval operator*(const BigInterval& a, const BigInterval& b) {
    if (is_nan(a) || is_nan(b)) {
        return is_nan(a) ? a : b;
    }
    BigInterval result;
    const bool a_pos = is_at_least_0(a.lower()), a_neg = is_at_most_0(a.upper());
    const bool b_pos = is_at_least_0(b.lower()), b_neg = is_at_most_0(b.upper());
    if (!a_pos && !a_neg && !b_pos && !b_neg) {
        BigInterval other;
        multiply(result.lower(), a.lower(), b.upper(), down);
        multiply(other.lower(), a.upper(), b.lower(), down);
        multiply(result.upper(), a.lower(), b.lower(), up);
        multiply(other.upper(), a.upper(), b.upper(), up);
        return hull(result, other);
    }
    // Each bound is the product of two ends that the signs tell.
    const auto end = [](const BigInterval& x, bool low) { return low ? x.lower() : x.upper(); };
    multiply(result.lower(), end(a, b_pos || (!b_neg && !a_pos)), end(b, a_pos || (!a_neg && !b_pos)), down);
    multiply(result.upper(), end(a, b_neg || (!b_pos && !a_pos)), end(b, a_neg || (!a_pos && !b_pos)), up);
    return result;
}
BigInterval operator/(const BigInterval& a, const BigInterval& b) {
    if (is_nan(a) || is_nan(b)) {
        return is_nan(a) ? a : b;
    }
    const bool b_pos = arf_sgn(b.lower()) > 0;
    if (!b_pos && arf_sgn(b.upper()) >= 0) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        return {-infinity, infinity};
    }
    BigInterval result;
    // Of b's ends, the nearer to 0 makes a quotient larger in size.
    arf_srcptr near = b_pos ? b.lower() : b.upper();
    arf_srcptr far = b_pos ? b.upper() : b.lower();
    arf_srcptr least = b_pos ? a.lower() : a.upper();
    arf_srcptr greatest = b_pos ? a.upper() : a.lower();
    const bool least_is_positive = b_pos ? is_at_least_0(least) : is_at_most_0(least);
    const bool greatest_is_positive = b_pos ? is_at_least_0(greatest) : is_at_most_0(greatest);
    arf_div(result.lower(), least, least_is_positive ? far : near, working_bits, down);
    arf_div(result.upper(), greatest, greatest_is_positive ? near : far, working_bits, up);
    spread_nan(result);
    return result;
}
BigInterval operator-(const BigInterval& a) {
    BigInterval result;
    arf_neg_round(result.lower(), a.upper(), working_bits, down);
    arf_neg_round(result.upper(), a.lower(), working_bits, up);
    return result;
}
BigInterval sqr(const BigInterval& a) {
    if (is_nan(a)) {
        return a;
    }
    const bool ascending = arf_cmpabs(a.lower(), a.upper()) <= 0;
    arf_srcptr small = ascending ? a.lower() : a.upper();
    arf_srcptr large = ascending ? a.upper() : a.lower();
    BigInterval result;
    if (is_at_least_0(a.lower()) || is_at_most_0(a.upper())) {
        arf_mul(result.lower(), small, small, working_bits, down);
    }
    arf_mul(result.upper(), large, large, working_bits, up);
    return result;
}
BigInterval sqrt(const BigInterval& a) {
    if (is_nan(a)) {
        return a;
    }
    BigInterval result;
    if (!is_at_most_0(a.lower())) {
        arf_sqrt(result.lower(), a.lower(), working_bits, down);
    }
    if (!is_at_most_0(a.upper())) {
        arf_sqrt(result.upper(), a.upper(), working_bits, up);
    }
    return result;
}

namespace {

arf_srcptr lesser(arf_srcptr x, arf_srcptr y) { return arf_cmp(x, y) <= 0 ? x : y; }
arf_srcptr greater(arf_srcptr x, arf_srcptr y) { return arf_cmp(x, y) >= 0 ? x : y; }

/// The chosen ends. arf_cmp says nothing of NaN.
template <class Lower, class Upper>
BigInterval combined(const BigInterval& a, const BigInterval& b, Lower lower, Upper upper) {
    if (is_nan(a) || is_nan(b)) {
        return is_nan(a) ? a : b;
    }
    BigInterval result;
    arf_set_round(result.lower(), lower(a.lower(), b.lower()), working_bits, down);
    arf_set_round(result.upper(), upper(a.upper(), b.upper()), working_bits, up);
    return result;
}

}  // namespace

BigInterval hull(const BigInterval& a, const BigInterval& b) { return combined(a, b, lesser, greater); }
BigInterval min(const BigInterval& a, const BigInterval& b) { return combined(a, b, lesser, lesser); }
BigInterval max(const BigInterval& a, const BigInterval& b) { return combined(a, b, greater, greater); }

namespace {

/// A ball of Arb's.
class Ball {
  public:
    Ball() noexcept { arb_init(value_); }
    Ball(const Ball&) = delete;
    Ball& operator=(const Ball&) = delete;
    ~Ball() { arb_clear(value_); }
    operator arb_ptr() noexcept { return value_; }

  private:
    arb_t value_;
};

/// The point x as a ball that shares its digits, to be read only.
arb_struct as_ball(arf_srcptr x) {
    arb_struct ball{};  // zero bits are a radius 0
    ball.mid = *x;
    return ball;
}

/// Bits beyond which no function below looks for the tightest result: only sines of numbers that are absurdly
/// small or large need them.
constexpr slong most_bits = 1 << 22;

/// Makes `to` the tightest enclosure of the number in `value`, and says true, if `value` is narrow enough to
/// tell it: if all of it has one value L rounded down, it lies in [L, the next number after L), so that its
/// middle rounded up is no less than any of it.
bool round_tightly(BigInterval& to, arb_srcptr value) {
    if (arb_can_round_arf(value, working_bits, down) == 0) {
        return false;
    }
    arf_set_round(to.lower(), arb_midref(value), working_bits, down);
    arf_set_round(to.upper(), arb_midref(value), working_bits, up);
    return true;
}

/// Calls evaluate(bits) with more and more bits until it is true. Arb encloses what it evaluates; but for the
/// arguments where it is exact, no result here is a number of finitely many bits, so some precision does.
template <class Evaluate>
void until_tight(const Evaluate& evaluate) {
    for (slong bits = working_bits + 16; !evaluate(bits) && bits < most_bits; bits *= 2) {
    }
}

/// The tightest enclosure of function(x), or any where that needs too many bits.
template <class Function>
BigInterval at_point(const Function& function, arf_srcptr x) {
    BigInterval result;
    Ball value;
    const arb_struct point = as_ball(x);
    until_tight([&](slong bits) {
        function(value, &point, bits);
        arb_get_interval_arf(result.lower(), result.upper(), value, working_bits);
        return round_tightly(result, value);
    });
    return result;
}

SinCos<BigInterval> sin_cos_at(arf_srcptr x) {
    SinCos<BigInterval> result{BigInterval(-1, 1), BigInterval(-1, 1)};
    Ball sine, cosine;
    const arb_struct point = as_ball(x);
    until_tight([&](slong bits) {
        arb_sin_cos(sine, cosine, &point, bits);
        const bool sine_is_tight = round_tightly(result.sin, sine);
        return round_tightly(result.cos, cosine) && sine_is_tight;
    });
    return result;
}

/// The range of sine or cosine between two points less than pi apart, from its values and its derivative's
/// there: the derivative has at most one zero between them, and changes its sign there.
BigInterval range_between(const BigInterval& at_lower, const BigInterval& slope_at_lower,
                          const BigInterval& at_upper, const BigInterval& slope_at_upper) {
    BigInterval result = hull(at_lower, at_upper);
    if (arf_sgn(slope_at_lower.upper()) > 0 && arf_sgn(slope_at_upper.lower()) < 0) {
        arf_one(result.upper());
    }
    if (arf_sgn(slope_at_lower.lower()) < 0 && arf_sgn(slope_at_upper.upper()) > 0) {
        arf_set_si(result.lower(), -1);
    }
    return result;
}

}  // namespace

SinCos<BigInterval> sin_cos(const BigInterval& x) {
    const double length = width(x);
    if (arf_is_finite(x.lower()) == 0 || arf_is_finite(x.upper()) == 0 || length > 7) {
        const BigInterval all = is_nan(x) ? x : BigInterval(-1, 1);
        return {all, all};
    }
    if (arf_equal(x.lower(), x.upper()) != 0) {
        return sin_cos_at(x.lower());
    }
    if (length > 3) {  // in two parts, which meet
        BigInterval first = x, second = x;
        arf_add(first.upper(), x.lower(), x.upper(), ARF_PREC_EXACT, down);
        arf_mul_2exp_si(first.upper(), first.upper(), -1);
        arf_set(second.lower(), first.upper());
        const auto left = sin_cos(first), right = sin_cos(second);
        return {hull(left.sin, right.sin), hull(left.cos, right.cos)};
    }
    const auto from = sin_cos_at(x.lower()), to = sin_cos_at(x.upper());
    return {range_between(from.sin, from.cos, to.sin, to.cos),
            range_between(from.cos, -from.sin, to.cos, -to.sin)};
}
BigInterval asin(const BigInterval& x) {
    if (is_nan(x)) {
        return x;
    }
    const BigInterval part = min(max(x, BigInterval(-1)), BigInterval(1));
    return hull(at_point(arb_asin, part.lower()), at_point(arb_asin, part.upper()));
}
BigInterval log(const BigInterval& x) {
    if (!certainly_positive(x) || arf_is_finite(x.upper()) == 0) {
        return BigInterval(std::numeric_limits<double>::quiet_NaN());
    }
    return hull(at_point(arb_log, x.lower()), at_point(arb_log, x.upper()));
}
template <>
BigInterval pi<BigInterval>() {
    thread_local BigInterval known;
    thread_local int known_bits = 0;
    if (known_bits != working_bits) {
        Ball value;
        until_tight([&](slong bits) {
            arb_const_pi(value, bits);
            return round_tightly(known, value);
        });
        known_bits = working_bits;
    }
    return known;
}
template <>
BigInterval half_pi<BigInterval>() {
    BigInterval result = pi<BigInterval>();
    arf_mul_2exp_si(result.lower(), result.lower(), -1);
    arf_mul_2exp_si(result.upper(), result.upper(), -1);
    return result;
}

BigInterval two_to(long exponent) {
    BigInterval result(1);
    arf_mul_2exp_si(result.lower(), result.lower(), exponent);
    arf_set(result.upper(), result.lower());
    return result;
}

BigInterval low_end(const BigInterval& x) {
    BigInterval result;
    arf_set_round(result.lower(), x.lower(), working_bits, down);
    arf_set(result.upper(), result.lower());
    return result;
}
BigInterval high_end(const BigInterval& x) {
    BigInterval result;
    arf_set_round(result.upper(), x.upper(), working_bits, up);
    arf_set(result.lower(), result.upper());
    return result;
}
bool certainly_less(const BigInterval& x, const BigInterval& y) {
    return !is_nan(x) && !is_nan(y) && arf_cmp(x.upper(), y.lower()) < 0;
}
bool certainly_at_most(const BigInterval& x, const BigInterval& y) {
    return !is_nan(x) && !is_nan(y) && arf_cmp(x.upper(), y.lower()) <= 0;
}
bool certainly_positive(const BigInterval& x) { return arf_sgn(x.lower()) > 0; }

namespace {

/// The middle of X, rounded to nearest.
void middle(arf_ptr to, const BigInterval& x, slong bits) {
    arf_add(to, x.lower(), x.upper(), bits, ARF_RND_NEAR);
    arf_mul_2exp_si(to, to, -1);
}

}  // namespace

double approximate(const BigInterval& x) {
    BigInterval at;
    middle(at.lower(), x, 53);
    return arf_get_d(at.lower(), ARF_RND_NEAR);
}
double width(const BigInterval& x) {
    BigInterval diameter;
    arf_sub(diameter.upper(), x.upper(), x.lower(), working_bits, up);
    return diameter.hi();
}
BigInterval midpoint(const BigInterval& x) {
    BigInterval result;
    middle(result.lower(), x, working_bits);
    arf_set(result.upper(), result.lower());
    return result;
}

}  // namespace dumbbell
