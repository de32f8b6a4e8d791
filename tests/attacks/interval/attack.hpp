#pragma once

#include <array>
#include <cstdio>
#include <mutex>
#include <string>
#include <vector>

#include "catch.hpp"
#include "draw.hpp"
#include "exact.hpp"
#include "layers.hpp"
#include "scale.hpp"

/// The attack: many adversarial arguments of one function, each result held against the exact range.
namespace dumbbell_test {

/// The results of one function of one layer, by the excess of the worse end: 0 units in the last place, 1,
/// up to 16, more, unbounded.
class Tally {
  public:
    void add(double ulps) {
        ++count_;
        ++by_excess_.at(ulps <= 0 ? 0 : ulps <= 1 ? 1 : ulps <= 16 ? 2 : ulps < HUGE_VAL ? 3 : 4);
    }
    /// Results with an excess of more than 1.
    [[nodiscard]] long loose() const { return by_excess_[2] + by_excess_[3] + by_excess_[4]; }
    [[nodiscard]] long not_tight() const { return by_excess_[1] + loose(); }

    void print(const char* layer, const char* function) const {
        static std::once_flag head;
        std::call_once(head, [] {
            std::printf("%-16s %-10s %8s %8s %9s %9s %9s %9s %9s\n", "layer", "function", "samples",
                        "failures", "excess 0", "1 ulp", "2 to 16", "more", "unbounded");
        });
        std::printf("%-16s %-10s %8ld %8d", layer, function, count_, 0);  // the first failure ends the test
        for (const long n : by_excess_) {
            std::printf(" %9ld", n);
        }
        std::printf("\n");
    }

  private:
    long count_ = 0;
    std::array<long, 5> by_excess_{};
};

inline std::string show(mpfr_srcptr x) {
    char* text = nullptr;
    mpfr_asprintf(&text, "%Ra", x);
    std::string result = text;
    mpfr_free_str(text);
    return result;
}
inline std::string show(Ends& x) { return "[" + show(mpfr_ptr(x.lo)) + ", " + show(mpfr_ptr(x.hi)) + "]"; }

/// The doubles or the units in the last place between a bound and the exact one, which is beyond it inwards.
template <class L>
double excess_of(mpfr_ptr bound, mpfr_ptr exact, mpfr_rnd_t outward) {
    if (L::in_double) {
        const double tightest = mpfr_get_d(exact, outward);
        const double ours = mpfr_get_d(bound, MPFR_RNDN);
        const double steps = std::abs(static_cast<double>(ulps_between(ours, tightest)));
        return steps > 1 && std::isinf(ours) ? HUGE_VAL : steps;
    }
    Mpfr tightest(L::bits(), 0);
    mpfr_set(tightest, exact, outward);
    mpfr_sub(tightest, tightest, bound, MPFR_RNDA);
    if (mpfr_zero_p(mpfr_ptr(tightest)) != 0) {
        return 0;
    }
    if (mpfr_regular_p(exact) == 0 || mpfr_number_p(mpfr_ptr(tightest)) == 0) {
        return HUGE_VAL;
    }
    mpfr_mul_2si(tightest, tightest, L::bits() - mpfr_get_exp(exact), MPFR_RNDA);
    return std::abs(mpfr_get_d(tightest, MPFR_RNDA));
}

/// Fails unless the result holds the whole range; `arguments` are shown then.
template <class L, class... Arguments>
void judge(Tally& tally, const char* function, const typename L::I& result, Hull& exact,
           Arguments&... arguments) {
    static thread_local Mpfr lo(4096, 0);
    static thread_local Mpfr hi(4096, 0);
    L::low(lo, result);
    L::high(hi, result);
    // Written so that NaN fails.
    if (!(mpfr_lessequal_p(mpfr_ptr(lo), exact.lo()) != 0 &&
          mpfr_greaterequal_p(mpfr_ptr(hi), exact.hi()) != 0)) {
        std::string text = std::string(L::name) + ": " + function + " of";
        ((text += " " + show(arguments)), ...);
        FAIL(text << " is [" << show(mpfr_ptr(lo)) << ", " << show(mpfr_ptr(hi)) << "], exact ["
                  << show(exact.lo()) << ", " << show(exact.hi()) << "]");
    }
    tally.add(std::max(excess_of<L>(lo, exact.lo(), MPFR_RNDD), excess_of<L>(hi, exact.hi(), MPFR_RNDU)));
}

/// The precisions at which a layer is attacked, with equal shares of the samples.
template <class L>
std::vector<int> precisions() {
    return L::in_double ? std::vector<int>{53} : std::vector<int>{53, 64, 113, 237, 300};
}

/// Bits of the exact side beyond the layer's.
constexpr int room = 64;

/// Calls body(tally, random, bits) for every sample and prints the results.
template <class L, class Body>
Tally attack(const char* function, std::uint64_t seed, const Body& body) {
    Random random(seed);
    Tally all;
    for (const int bits : precisions<L>()) {
        const WorkingBits scope(bits);
        const long count = scaled(6'000) / static_cast<long>(precisions<L>().size());
        for (long i = 0; i < count; ++i) {
            body(all, random, bits);
        }
    }
    all.print(L::name, function);
    return all;
}

}  // namespace dumbbell_test
