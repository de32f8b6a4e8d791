#include "file/sealed_digest.hpp"

#include <fmt/core.h>

#include <string_view>

#include "base/error.hpp"
#include "file/sha256.hpp"
#include "file/unpacked_text.hpp"

namespace dumbbell {

std::string sealed_digest(const std::string& path) {
    constexpr std::string_view first_line = "dumbbell-certificate 1\n", seal = "sha256 ";
    UnpackedText text(path);
    if (text.next_line() != first_line) {
        throw InputError(fmt::format("'{}' is not a certificate: its first line is not '{}'", path,
                                     first_line.substr(0, first_line.size() - 1)));
    }
    Sha256 digest;
    digest.add(first_line);
    std::string_view line = text.next_line();
    for (; !line.empty() && !line.starts_with(seal); line = text.next_line()) {
        digest.add(line);
    }
    std::string right = digest.hex();
    if (line == fmt::format("{}{}\n", seal, right) && text.next_line().empty()) {
        return right;
    }
    throw InputError(fmt::format(
        "'{}' is damaged: its last line is not the checksum of its text (dumbbell verify says more)", path));
}

}  // namespace dumbbell
