// What the core asks of others, all of it. Of a certificate of section `turning` whose rays have fewer than
// 20,000 collisions nothing that is certified rests on any of this.
#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "verify/core/interval.hpp"

namespace dumbbell_verify {

/// The bytes of a file (verify/input). Whatever they are, what is certified is what they say.
struct Source {
    virtual ~Source() = default;
    /// The next block, good until the one after it; empty at the end. What is wrong is said to be in this
    /// line.
    virtual std::string_view next(std::uint64_t line) = 0;
    /// What another system has made of a line, and how to mend it; empty: nothing that has a name.
    [[nodiscard]] virtual std::string foreign(std::string_view line, bool is_first) const = 0;
};

// What a file may cost (verify/machine). It is counted in units, not by a clock: the verdict is the same on
// every machine and with any number of threads (format.md, section 4). All that comes of it is an exception.
constexpr std::uint64_t units_per_second = 6'000'000'000;  ///< of about one second of a core
constexpr std::uint64_t default_budget = 30 * units_per_second;

/// Of a file, in units; its reader and what it reads share it.
class Budget {
  public:
    explicit Budget(std::uint64_t units) : all_(units), left_(units) {}
    [[nodiscard]] std::uint64_t left() const { return left_; }
    [[nodiscard]] std::uint64_t taken() const { return all_ - left_; }
    /// Throws Failure if there is not so much; then nothing is left.
    void take(std::uint64_t units, std::uint64_t line);

  private:
    std::uint64_t all_, left_;
};

/// Of what this thread does for its present leaf. Throws std::length_error if the leaf's share is used up.
struct Work {
    using Ends = std::span<const mpq_class>;
    static void operation(std::uint64_t bits);  ///< in multiple precision
    static void collision();                    ///< of a ray, in double
    static std::uint64_t of_halving(const mpq_class& lo, const mpq_class& hi);
    static std::uint64_t of_box(Ends lo, Ends hi, int depth);  ///< 2^-depth of the root box
};

/// Does task(0) to task(n - 1) on so many threads, but for those behind one that gave false or went over its
/// share; what each has cost.
std::vector<std::uint64_t> share_out(std::size_t n, std::size_t threads, const Budget& budget,
                                     const std::function<bool(std::size_t)>& task);

/// Whether this thread rounds as IEEE 754 says, whatever the compiler and the program around did.
bool arithmetic_works();

/// For people who wait: of all files so far.
struct Watched {
    inline static std::atomic<std::uint64_t> bytes = 0;                       ///< that were read, unpacked
    inline static std::atomic<std::uint64_t> work = 0, read = 0, pieces = 0;  ///< `read` of all `pieces`
};

struct Leaf;
struct Chart;
/// What --explain shows of a check, a line for every inequality (verify/program).
class Log {
  public:
    /// A number behind a name, rounded outward to doubles.
    struct Shown {
        const char* name;
        Interval<double> number;
        template <class N>
        Shown(const char* text, const Interval<N>& x)
            : name(text), number(to_double(down, x.lo), to_double(up, x.hi)) {}
    };
    using Line = std::initializer_list<Shown>;

    std::string text;
    void line(Line numbers);
    void fact(const char* what, bool holds);
    void ray(const mpz_class& collisions, Line numbers);  ///< a ray behind so many collisions
    void there(Line numbers);                             ///< what becomes of it, on the same line
    void leap(const mpz_class& collisions);
    void box(const Leaf& leaf, const Chart& chart, long bits);
    void show(bool certified);  ///< to the referee

  private:
    std::vector<std::string> ray_;  ///< the lines about the present one
};

/// Guesses, from which certified steps start (verify/guess): near the least root of sin x = c + kappa x, from
/// z, and false if there seems to be none; near the z in [0, quarter] with cos z = kappa.
template <class N>
bool guess_root(const N& c, const N& kappa, N& z);
template <class N>
N guess_top(const N& kappa, const N& quarter);

/// Many collisions at once, of rays that have 20,000 or more (verify/macro): here alone something is
/// certified, by L42. Whether `hits` comes true, with leaps or one collision after the other (nullptr).
class Leaps;
bool by_leaps(const mpz_class& collisions, const std::function<bool(Leaps*)>& hits);
constexpr unsigned least_worth_leaps = 20'000;
/// Moves the bound of rays behind a collision at x over as many collisions as it can, at most `left`, of
/// which it takes them. False if there are too many left to go one by one.
template <class N>
struct RayBound;
template <class N>
bool leap(Leaps& leaps, Round d, RayBound<N>& ray, const N& x, mpz_class& left, Log* log);

}  // namespace dumbbell_verify
