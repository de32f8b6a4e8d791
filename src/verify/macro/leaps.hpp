// Where the macro steps of one ray are tried.
#pragma once
#include <optional>

#include "verify/core/outside.hpp"
#include "verify/macro/macro.hpp"

namespace dumbbell_verify {

/// The macro steps of a bound of rays that is followed over many collisions. A few may fail: first where the
/// orbit has hardly begun, at last where it ends.
class Leaps {
  public:
    [[nodiscard]] bool may() const { return attempts_ > 0; }
    /// False if the last macro step is far behind: there are too many collisions left to go one by one.
    [[nodiscard]] bool near(const mpz_class& left) const { return !last_ || *last_ - left < 4'000'000; }

    /// macro_step as long as it moves the bound, which it takes from `left`; true if it did.
    bool over(Round d, WallBound& bound, long bits, mpz_class& left, Log* log) {
        const mpz_class before = left;
        for (mpz_class more = 1; more > 0 && left > 0; left -= more) {
            more = macro_step(d, bound, left, bits);
            if (more == 0) --attempts_;
            if (more > 0 && log) log->leap(more);
        }
        last_ = left;
        return left < before;
    }

  private:
    int attempts_ = 4;
    std::optional<mpz_class> last_;
};

}  // namespace dumbbell_verify
