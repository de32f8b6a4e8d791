#include "file/shipped.hpp"

#include <fmt/core.h>

#include <filesystem>

#include "base/error.hpp"

namespace dumbbell {

std::string shipped_certificate(std::string_view name) {
    // bin/dumbbell below a prefix, or build/bin/dumbbell below the source.
    const auto above = std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path();
    for (const auto& folder : {above / "share/dumbbell/certificates", above.parent_path() / "certificates"}) {
        std::error_code error;
        if (std::filesystem::is_regular_file(folder / name, error)) {
            return (folder / name).string();
        }
    }
    throw InputError(
        fmt::format("the certificate {} that comes with this program is not found: name it, or install the "
                    "program with its certificates",
                    name));
}

}  // namespace dumbbell
