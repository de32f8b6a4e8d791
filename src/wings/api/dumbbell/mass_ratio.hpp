#pragma once

#include <string>
#include <string_view>

#include "dumbbell/abi.hpp"

namespace dumbbell::api {
inline namespace DUMBBELL_ABI {

/// A mass ratio q = heavy mass / light mass >= 1, or a closed range of them, exactly.
class MassRatio {
  public:
    /// `10`, `4.6`, `1e6` or `9/2`, exactly as written, or a closed range of two of these, `1:100`. Below 1
    /// the masses are swapped, q -> 1/q. Throws InputError for any other text, the number 0, a range that is
    /// reversed or crosses 1, more than 2,100 characters, and exponents beyond 1000.
    [[gnu::visibility("default")]] explicit MassRatio(std::string_view text);

    /// The ends, which are equal for a single ratio: `9/2`, `10/1`, in lowest terms.
    [[nodiscard]] const std::string& lo() const noexcept { return lo_; }
    [[nodiscard]] const std::string& hi() const noexcept { return hi_; }

  private:
    std::string lo_;
    std::string hi_;
};

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
