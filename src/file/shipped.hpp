#pragma once

#include <string>
#include <string_view>

namespace dumbbell {

/// A certificate that comes with the program: beside it as it was installed (share/dumbbell/certificates), or
/// in the source tree in which it was built. Throws InputError if it is in neither place, with the command by
/// which another one is named, such as `law FILE`; empty: there is none.
[[nodiscard]] std::string shipped_certificate(std::string_view name, std::string_view another = "");

}  // namespace dumbbell
