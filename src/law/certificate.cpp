#include "law/certificate.hpp"

#include <fmt/core.h>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "file/lines.hpp"

namespace dumbbell::law {

std::string basis_text(const std::string& file, const std::string& sha256) {
    return fmt::format(
        "This rests on the law for every mass ratio (proofs/law.md) with its certificate\n"
        "{} (sha256 {}); dumbbell law checks it.\n",
        one_line(file), sha256);
}

bool is_law_certificate(const std::string& path) try {
    constexpr int before = 5;
    Lines lines(path);
    for (int i = 0; i < before; ++i) {
        lines.next();
    }
    return lines.expect("claim", 2)[1] == "law";
} catch (const InputError&) {
    return false;
}

}  // namespace dumbbell::law
