#pragma once

#include <string>
#include <string_view>

namespace dumbbell {

/// A certificate that comes with the program: beside it as it was installed (share/dumbbell/certificates), or
/// in the source tree in which it was built. Throws InputError if it is in neither place.
[[nodiscard]] std::string shipped_certificate(std::string_view name);

}  // namespace dumbbell
