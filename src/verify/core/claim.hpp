// The claim kind `collisions`: what the pieces of a file say together, and whether it proves what is
// demanded.
#pragma once
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dumbbell_verify {

using Range = std::pair<mpq_class, mpq_class>;
std::string to_string(const mpq_class& ratio);                    ///< P/Q
std::string to_string(const mpq_class& lo, const mpq_class& hi);  ///< LO:HI
/// For a claim about the ratios [lo, hi] that was asked about [from, to], and does not cover them: what it
/// covers.
std::string covered_part(const mpq_class& lo, const mpq_class& hi, const mpq_class& from,
                         const mpq_class& to);

/// For all pieces so far: N*(q) <= upper if it is a number, N*(q) >= lower.
struct Bounds {
    std::optional<mpz_class> upper;  ///< the largest; none if a piece has none
    mpz_class lower;                 ///< the least
    std::uint64_t pieces = 0, gaps = 0, open = 0;

    Bounds() = default;
    Bounds(const std::optional<mpz_class>& u, const mpz_class& v);  ///< of one piece
    void join(const Bounds& next);                                  ///< of other mass ratios
    void meet(const Bounds& next);                                  ///< of the same mass ratio
};

/// What a file says, and what is demanded of it.
struct Collisions : Bounds {
    std::optional<Range> ratios, rhos;     ///< demanded; else the file's
    std::optional<mpz_class> most, least;  ///< demanded: N* <= most, N* >= least on `ratios`

    mpq_class lo, hi;          ///< of the file
    std::optional<Range> rho;  ///< of the file, if it is about bodies
    Bounds asked;              ///< of the pieces that `ratios` is about, or all

    /// The pieces come in increasing order, [lo, hi] of the file is their union.
    void add(const mpq_class& a, const mpq_class& b, const std::optional<mpz_class>& u, const mpz_class& v);
    /// Empty if the pieces with an upper bound <= most cover `ratios`, and those with a lower bound >= least
    /// do.
    [[nodiscard]] std::string missing() const;
    /// No bound is demanded, and none holds for all the mass ratios that are asked about.
    [[nodiscard]] bool says_nothing() const { return !most && !least && !asked.upper && asked.lower == 0; }

    /// Where what is asked begins in the file, if it does.
    [[nodiscard]] const mpq_class& start() const { return ratios ? std::max(ratios->first, lo) : lo; }
    /// Where the cover by closed pieces that prove it has arrived, from there: the ratios, most, least.
    std::array<std::optional<mpq_class>, 3> reached;
    void ask(const Bounds& next);
};

}  // namespace dumbbell_verify
