// The vocabulary of number.hpp on MPFR: the same guarantees at any precision. Plain operators it has none:
// there is no rounding by accident.
#pragma once
#include <algorithm>
#include <compare>
#include <concepts>
#include <memory>

#include "verify/core/outside.hpp"

namespace dumbbell_verify {

class Big {
  public:
    inline static thread_local mpfr_prec_t precision = 53;  ///< of all numbers of this thread

    Big() : Big(0) {}
    Big(std::same_as<int> auto n) : Big(Unset{}) {  // NOLINT(google-explicit-constructor): exact
        mpfr_set_si(x_, n, MPFR_RNDN);
    }
    /// Exact, whatever the precision is by now; so is negation.
    Big(const Big& other) : Big(Unset{mpfr_get_prec(other.x_)}) { mpfr_set(x_, other.x_, MPFR_RNDN); }
    Big& operator=(const Big& other) {
        if (this != &other) std::construct_at((std::destroy_at(this), this), other);
        return *this;
    }
    ~Big() {
        if (mpfr_custom_get_significand(x_) != room_) mpfr_clear(x_);
    }

    /// The function's value, rounded; unbounded where that is no number (overflow, inf - inf).
    template <class Function, class... Values>
    static Big rounded(Round d, Function function, Values... values) {
        Work::operation(static_cast<std::uint64_t>(precision));
        Big result{Unset()};
        function(result.x_, values..., d == up ? MPFR_RNDU : MPFR_RNDD);
        if (!mpfr_number_p(result.x_)) mpfr_set_inf(result.x_, d == up ? 1 : -1);
        return result;
    }
    [[nodiscard]] mpfr_srcptr get() const { return x_; }

    friend Big operator-(Big a) {
        Work::operation(static_cast<std::uint64_t>(precision));
        mpfr_neg(a.x_, a.x_, MPFR_RNDN);
        return a;
    }
    friend bool operator==(const Big& a, const Big& b) { return mpfr_equal_p(a.x_, b.x_) != 0; }
    friend std::weak_ordering operator<=>(const Big& a, const Big& b) { return mpfr_cmp(a.x_, b.x_) <=> 0; }
    friend std::weak_ordering operator<=>(const Big& a, std::same_as<int> auto b) {
        return mpfr_cmp_si(a.x_, b) <=> 0;
    }

  private:
    struct Unset {  ///< is given a value before anything else
        mpfr_prec_t bits = precision;
    };
    explicit Big(Unset unset) {
        if (unset.bits <= std::ssize(room_) * GMP_NUMB_BITS)
            mpfr_custom_init_set(x_, MPFR_ZERO_KIND, 0, unset.bits, room_);
        else
            mpfr_init2(x_, unset.bits);
    }

    mpfr_t x_;
    mp_limb_t room_[320 / GMP_NUMB_BITS];  ///< for its bits, if they fit: allocating costs more than a sum
};

inline Big add(Round d, const Big& a, const Big& b) { return Big::rounded(d, mpfr_add, a.get(), b.get()); }
inline Big sub(Round d, const Big& a, const Big& b) { return Big::rounded(d, mpfr_sub, a.get(), b.get()); }
inline Big mul(Round d, const Big& a, const Big& b) { return Big::rounded(d, mpfr_mul, a.get(), b.get()); }
inline Big div(Round d, const Big& a, const Big& b) {  // inf / inf is no number
    return Big::rounded(d, mpfr_div, mpfr_number_p(b.get()) ? a.get() : b.get(), b.get());
}
inline Big div(Round d, const Big& a, std::same_as<int> auto n) {
    return Big::rounded(d, mpfr_div_si, a.get(), long{n});
}
inline Big bound(Round d, const mpq_class& x, const Big&) {
    return Big::rounded(d, mpfr_set_q, x.get_mpq_t());
}
inline Big pi_bound(Round d, const Big&) { return Big::rounded(d, mpfr_const_pi); }
inline double to_double(Round d, const Big& a) {
    return mpfr_get_d(a.get(), d == up ? MPFR_RNDU : MPFR_RNDD);
}
inline long bits(const Big&) { return Big::precision; }
/// So many brackets that what is left of the series, y/(1 2) y/(3 4) ..., is below the last bit, for y <= 4.
inline int terms(const Big& y) {
    const int most = static_cast<int>(Big::precision / 8) + 14;
    const long size = y > 0 ? std::min<long>(mpfr_get_exp(y.get()), 3) : -Big::precision;
    int n = Big::precision > 64 ? 1 : most;
    for (long left = Big::precision; left > 0 && n < most; ++n)
        left += size + 1 - std::bit_width(static_cast<unsigned>(2 * n * (2 * n - 1)));
    return n;
}

/// What `check` finds missing; enclosures that exclude each other prove nothing.
template <class Check>
const char* checked(const Check& check) try {
    return check();
} catch (const Excluded&) {
    return "two enclosures of the same thing exclude each other";
}

/// nullptr if Judge certifies the leaf in double, or else in MPFR with the leaf's bits, of which 53 are
/// closer than double; otherwise what is missing. A leaf that is `multiple` is not tried in double. Judge
/// needs a name that no other judge of this leaf type has: g++ merges the instances of equally named
/// templates, though they are in unnamed namespaces.
template <template <class> class Judge, class AnyLeaf>
const char* judged(const AnyLeaf& leaf, Log* log) {
    if (!leaf.multiple && !checked([&] { return Judge<double>(leaf, log).verdict(); })) return nullptr;
    Big::precision = leaf.bits;
    return checked([&] { return Judge<Big>(leaf, log).verdict(); });
}

}  // namespace dumbbell_verify
