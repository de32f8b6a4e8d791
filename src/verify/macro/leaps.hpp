// Where the macro steps of one ray are tried.
#pragma once
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "verify/macro/macro.hpp"
#include "verify/number/integer.hpp"

namespace dumbbell_verify {

/// n, which fits.
template <class Count>
Count as(const mpz_class& n) {
    if constexpr (std::is_same_v<Count, mpz_class>)
        return n;
    else
        return unsigned_64(n);
}

/// The macro steps of a bound of rays that is followed over many collisions. A few may fail: first where the
/// orbit has hardly begun, at last where it ends.
template <class Count>
class Leaps {
  public:
    /// With so few collisions none are tried.
    explicit Leaps(const Count& collisions) : attempts_(collisions < least_macro ? 0 : 4) {}

    [[nodiscard]] bool may() const { return attempts_ > 0; }
    /// False if collision `count` is far behind the last macro step: there are too many to go one by one.
    [[nodiscard]] bool near(const Count& count) const { return !last_ || count - *last_ < 4'000'000; }

    /// macro_step as long as it moves the bound, from `count` up to `most`, which it counts; true if it did.
    /// A log gets a line for each.
    bool over(Round d, WallBound& bound, const Count& most, long bits, Count& count,
              std::vector<std::string>* log) {
        const Count before = count;
        for (mpz_class more = 1; more > 0 && count < most; count += as<Count>(more)) {
            more = macro_step(d, bound, integer(Count(most - count)), bits);
            if (more == 0) --attempts_;
            if (more > 0 && log) log->push_back("    " + more.get_str() + " collisions by L42");
        }
        last_ = count;
        return count > before;
    }

  private:
    int attempts_;
    std::optional<Count> last_;
};

}  // namespace dumbbell_verify
