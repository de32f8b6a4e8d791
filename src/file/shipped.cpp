#include "file/shipped.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <initializer_list>

#include "base/error.hpp"

namespace dumbbell {
namespace {

/// The first of these files that there is, below the prefix: the folder of bin/dumbbell, which is build/ or
/// build/PRESET/ in the source tree.
std::optional<std::string> first_of(std::initializer_list<std::filesystem::path> files) {
    const auto prefix = std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path();
    for (const auto& file : files) {
        std::error_code error;
        const auto path = (prefix / file).lexically_normal();
        if (std::filesystem::is_regular_file(path, error)) {
            return path.string();
        }
    }
    return std::nullopt;
}

}  // namespace

std::string shipped_certificate(std::string_view name) {
    const std::filesystem::path folder = "certificates";
    if (auto file =
            first_of({"share/dumbbell" / folder / name, ".." / folder / name, "../.." / folder / name})) {
        return *file;
    }
    throw InputError(
        fmt::format("the certificate {} that comes with this program is not found: install the program with "
                    "its certificates",
                    name));
}

std::optional<std::string> verifier_for_pages() {
    return first_of({"share/dumbbell/verifier.wasm.gz", "web/verifier.wasm.gz", "../web/verifier.wasm.gz"});
}

}  // namespace dumbbell
