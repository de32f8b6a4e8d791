#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace dumbbell {

/// A certificate that comes with the program: beside it as it was installed (share/dumbbell/certificates), or
/// in the source tree in which it was built. Throws InputError if it is in neither place.
[[nodiscard]] std::string shipped_certificate(std::string_view name);

/// The verifier for pages, packed, made by ./run web: beside the program as it was installed, or in the
/// build folder. None if it is in neither place.
[[nodiscard]] std::optional<std::string> verifier_for_pages();

}  // namespace dumbbell
