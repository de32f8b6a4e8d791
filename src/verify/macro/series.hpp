// Polynomials in s with fixed-point coefficients, and a bound of how far they are from the function they
// stand for, on -1 <= s <= 1.
#pragma once
#include <gmpxx.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "verify/machine/integer.hpp"
#include "verify/machine/meter.hpp"

namespace dumbbell_verify {

/// floor(x 2^n), n of either sign.
inline mpz_class shifted(const mpz_class& x, long n) {
    mpz_class result;
    if (n >= 0)
        mpz_mul_2exp(result.get_mpz_t(), x.get_mpz_t(), static_cast<mp_bitcnt_t>(n));
    else
        mpz_fdiv_q_2exp(result.get_mpz_t(), x.get_mpz_t(), static_cast<mp_bitcnt_t>(-n));
    return result;
}
/// The least integer that is at least x 2^n.
inline mpz_class shifted_up(const mpz_class& x, long n) { return -shifted(-x, n); }

/// For every s in [-1, 1]: |f(s) - sum of term[i] s^i 2^-places| <= error 2^-places. All operations on series
/// keep that, for the functions they stand for. `terms` and `places` are the same for all that meet.
struct Series {
    std::vector<mpz_class> term;
    mpz_class error = 0;
    long places = 0;

    Series(std::size_t terms, long fixed) : term(terms), places(fixed) {}

    /// At least the sizes of the terms from degree `first` on, added up, and so (for 0, with the error) |f|.
    [[nodiscard]] mpz_class size(std::size_t first = 0) const {
        mpz_class sum = 0;
        for (std::size_t i = first; i < term.size(); ++i) sum += abs(term[i]);
        return sum;
    }
    /// The polynomial's value at s = 1 or -1, exactly.
    [[nodiscard]] mpz_class at(int s) const {
        mpz_class sum = 0;
        for (std::size_t i = 0; i < term.size(); ++i) sum += s < 0 && i % 2 ? -term[i] : term[i];
        return sum;
    }
    /// f 2^n m, for an integer m.
    [[nodiscard]] Series times(const mpz_class& m, long n) const {
        Series result(term.size(), places);
        for (std::size_t i = 0; i < term.size(); ++i) result.term[i] = shifted(term[i] * m, n);
        result.error = shifted_up(error * abs(m), n) + term.size();
        return result;
    }
};

inline Series operator+(Series a, const Series& b) {
    for (std::size_t i = 0; i < a.term.size(); ++i) a.term[i] += b.term[i];
    a.error += b.error;
    return a;
}
inline Series operator-(Series a, const Series& b) {
    for (std::size_t i = 0; i < a.term.size(); ++i) a.term[i] -= b.term[i];
    a.error += b.error;
    return a;
}

/// sum += x y, and its work.
inline void add_product(mpz_class& sum, const mpz_class& x, const mpz_class& y) {
    Meter::spend(36 + (x == 0 || y == 0 ? 0 : 126 + 9 * limbs(x) * limbs(y)));
    mpz_addmul(sum.get_mpz_t(), x.get_mpz_t(), y.get_mpz_t());
}

/// The coefficient i of a b, from the terms `first` to i of a, rounded down.
inline mpz_class coefficient(const Series& a, const Series& b, std::size_t i, std::size_t first = 0) {
    mpz_class sum = 0;
    for (std::size_t j = first; j <= i; ++j) add_product(sum, a.term[j], b.term[i - j]);
    return shifted(sum, -a.places);
}

/// The product. What is cut off, of degree >= terms, is at most the sum of its sizes.
inline Series operator*(const Series& a, const Series& b) {
    const std::size_t n = a.term.size();
    Series result(n, a.places);
    mpz_class tail = 0, cut = 0;  // tail: the sizes of b's terms from degree n - i on
    for (std::size_t i = 0; i < n; ++i) {
        result.term[i] = coefficient(a, b, i);
        cut += abs(a.term[i]) * tail;
        tail += abs(b.term[n - 1 - i]);
    }
    result.error =
        shifted_up(a.size() * b.error + b.size() * a.error + a.error * b.error + cut, -a.places) + n;
    return result;
}

/// How a polynomial changes over 2/k, by Taylor's formula.
class Difference {
  public:
    Difference(std::size_t terms, long places, const mpz_class& k) : weights_(terms) {
        std::vector<mpz_class> choose(terms);  // (m over j), for one m after the other
        mpz_class power = 1;                   // k^(j - 1)
        std::vector<mpz_class> small;          // (2/k)^(j - 1) 2^places, rounded down, as long as it is not 0
        for (std::size_t j = 1; j < terms && power <= shifted(1, places + static_cast<long>(j) - 1); ++j) {
            small.push_back(shifted(1, places + static_cast<long>(j) - 1) / power);
            power *= k;
        }
        Meter::spend(terms * small.size() * (60 + static_cast<std::uint64_t>(places) / 4));
        for (std::size_t m = 0; m < terms; ++m) {
            for (std::size_t j = m; j > 0; --j) choose[j] += choose[j - 1];
            choose[0] = 1;
            for (std::size_t j = 1; j <= std::min(m, small.size()); ++j)
                weights_[m].push_back(choose[j] * small[j - 1]);
        }
    }

    /// (f(s + 2/k) - f(s)) k/2 for s in [-1, 1 - 2/k], of the polynomial without its error: the sum of (m
    /// over j) term[m] (2/k)^(j - 1) s^(m - j). Each of the powers of 2/k is less than a unit off, those left
    /// out too, and the binomials of m add up to 2^m.
    [[nodiscard]] Series of(const Series& f) const {
        const std::size_t n = f.term.size();
        Series result(n, f.places);
        mpz_class all = 0;
        for (std::size_t m = 1; m < n; ++m) {
            for (std::size_t j = 1; j <= weights_[m].size(); ++j)
                add_product(result.term[m - j], f.term[m], weights_[m][j - 1]);
            all += shifted(abs(f.term[m]), static_cast<long>(m));
        }
        for (mpz_class& term : result.term) term = shifted(term, -f.places);
        result.error = shifted_up(all, -f.places) + n;
        return result;
    }

  private:
    std::vector<std::vector<mpz_class>> weights_;
};

}  // namespace dumbbell_verify
