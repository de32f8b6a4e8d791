#include "certificates/any_reader.hpp"

#include <fmt/core.h>

#include <string_view>

#include "adiabatic/reader.hpp"
#include "base/error.hpp"
#include "collisions/reader.hpp"
#include "file/lines.hpp"
#include "file/sha256.hpp"
#include "file/unpacked_text.hpp"
#include "starts/reader.hpp"

namespace dumbbell::certificates {
namespace {

constexpr int head_lines = 5;  // before the line `claim`
constexpr std::string_view first_line = "dumbbell-certificate 1\n", seal = "sha256 ";

}  // namespace

AnyCertificate read_any_certificate(const std::string& path) {
    Lines lines(path);
    for (int i = 0; i < head_lines; ++i) {
        lines.next();
    }
    const std::string claim = lines.expect("claim", 2)[1];
    if (claim == "initial-conditions" || claim == "incoming") {
        return starts::read_initial_certificate(path);
    }
    if (claim.starts_with("adiabatic-")) {
        return adiabatic::read_adiabatic_certificate(path);
    }
    if (claim == "law") {
        throw InputError(
            fmt::format("'{}' is about the law for every mass ratio (dumbbell law): no page and no picture "
                        "shows that; dumbbell verify checks it",
                        path));
    }
    return collisions::read_certificate(path);
}

std::string sealed_digest(const std::string& path) {
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

}  // namespace dumbbell::certificates
