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
/// For all pieces so far: N*(q) <= upper if it is a number, N*(q) >= lower.
struct Bounds {
    std::optional<mpz_class> upper;  ///< the largest; none if a piece has none
    mpz_class lower;                 ///< the least
    std::uint64_t pieces = 0, gaps = 0, open = 0;
    int leap = 1;  ///< the bounds of a gap differ by at most that; by more: open

    Bounds() = default;
    Bounds(const std::optional<mpz_class>& u, const mpz_class& v, int leap = 1);  ///< of one piece
    void join(const Bounds& next);                                                ///< of other mass ratios
    void meet(const Bounds& next);                                                ///< of the same mass ratio
};

/// The ratios at which N* is known: from `first` to `last`, but in gaps of at most this relative width. What
/// is known at a single ratio does not divide a gap.
struct Known {
    std::optional<mpq_class> first, last;
    mpq_class widest;
    mpz_class gaps = 0;
    void join(const Known& next);  ///< which begins where this ends, or behind
};

/// What a file says, and what is demanded of it.
struct Collisions : Bounds {
    std::optional<Range> ratios, rhos;     ///< demanded; else the file's
    std::optional<mpz_class> most, least;  ///< demanded: N* <= most, N* >= least on `ratios`
    /// Demanded: N* is known on `ratios`, but in gaps of this relative width, or in so many, in which it is
    /// one of 1 + leap neighbouring numbers. Of a single ratio it must be known.
    std::optional<mpq_class> gap;
    std::optional<mpz_class> gaps_at_most;

    mpq_class lo, hi;          ///< of the file
    std::optional<Range> rho;  ///< of the file, if it is about bodies
    Bounds asked;              ///< of the pieces that `ratios` is about, or all
    Known known;               ///< of these ratios

    /// The pieces come in increasing order, [lo, hi] of the file is their union.
    void add(const mpq_class& a, const mpq_class& b, const std::optional<mpz_class>& u, const mpz_class& v);
    /// Empty if the pieces with an upper bound <= most cover `ratios`, those with a lower bound >= least do,
    /// and the gaps are as demanded.
    [[nodiscard]] std::string missing() const;
    /// No bound is demanded, and none holds for all the mass ratios that are asked about.
    [[nodiscard]] bool says_nothing() const { return !most && !least && !asked.upper && asked.lower == 0; }

    [[nodiscard]] Range question() const { return ratios.value_or(Range(lo, hi)); }  ///< what is asked about
    [[nodiscard]] Known whole() const;  ///< the same up to the ends of `question`, or the file's
    [[nodiscard]] bool is_known_but_in_gaps() const;  ///< as is demanded
    /// Where what is asked begins in the file, if it does.
    [[nodiscard]] const mpq_class& start() const { return ratios ? std::max(ratios->first, lo) : lo; }
    /// Where the cover by closed pieces that prove it has arrived, from there: the ratios, most, least.
    std::array<std::optional<mpq_class>, 3> reached;
    void ask(const Bounds& next);
};

}  // namespace dumbbell_verify
