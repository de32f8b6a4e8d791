#include "file/shipped.hpp"

#include <fmt/core.h>

#include <filesystem>

#include "base/error.hpp"

namespace dumbbell {

std::string shipped_certificate(std::string_view name) {
    // bin/dumbbell below a prefix, or below build/ or build/PRESET/ in the source tree.
    const auto prefix = std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path();
    for (const auto& folder : {prefix / "share/dumbbell/certificates", prefix / "../certificates",
                               prefix / "../../certificates"}) {
        std::error_code error;
        const auto file = (folder / name).lexically_normal();
        if (std::filesystem::is_regular_file(file, error)) {
            return file.string();
        }
    }
    throw InputError(
        fmt::format("the certificate {} that comes with this program is not found: install the program with "
                    "its certificates",
                    name));
}

}  // namespace dumbbell
