// Where the macro steps of one ray are tried.
#pragma once
#include <string>
#include <vector>

#include "verify/macro/macro.hpp"

namespace dumbbell_verify {

/// The macro steps of a bound of rays that is followed over many collisions. A few may fail: first where the
/// orbit has hardly begun, at last where it ends.
class Leaps {
  public:
    /// With so few collisions none are tried.
    explicit Leaps(std::uint64_t collisions) : attempts_(collisions < least_macro ? 0 : 4) {}

    [[nodiscard]] bool may() const { return attempts_ > 0; }
    /// False if collision `count` is far behind the last macro step: there are too many to go one by one.
    [[nodiscard]] bool near(std::uint64_t count) const { return last_ == never || count - last_ < 4'000'000; }

    /// macro_step as long as it moves the bound, from `count` up to `most`, which it counts; true if it did.
    /// A log gets a line for each.
    bool over(Round d, WallBound& bound, std::uint64_t most, long bits, std::uint64_t& count,
              std::vector<std::string>* log) {
        const std::uint64_t before = count;
        for (std::uint64_t more = 1; more > 0 && count < most; count += more) {
            more = macro_step(d, bound, most - count, bits);
            if (more == 0) --attempts_;
            if (more > 0 && log) log->push_back("    " + std::to_string(more) + " collisions by L42");
        }
        last_ = count;
        return count > before;
    }

  private:
    static constexpr std::uint64_t never = UINT64_MAX;
    int attempts_;
    std::uint64_t last_ = never;
};

}  // namespace dumbbell_verify
