#include "collisions/verified.hpp"

#include <fmt/core.h>

#include "base/error.hpp"
#include "collisions/reader.hpp"
#include "collisions/section.hpp"
#include "file/verifier_program.hpp"

namespace dumbbell::collisions {

std::optional<Claim> claim_in(const std::string& file) try {
    const ClaimedHead head = read_head(file);
    const bool is_range =
        (head.system.rho ? head.range.lo > 0 : head.range.lo >= 1) && head.range.lo <= head.range.hi;
    return is_range ? std::optional(Claim{head.range, head.system}) : std::nullopt;
} catch (const InputError&) {
    return std::nullopt;
}

Certificate verified_certificate(const std::string& file, int jobs) {
    const std::string_view scene = row_of(read_head(file).system.section).scene;
    // A user who waits for it can stop it; a budget would only be in the way.
    const Verdict verdict = ask_verifier({fmt::format("--jobs={}", jobs), "--quiet", "--budget=99999h",
                                          fmt::format("--max-bits={}", most_file_bits),
                                          fmt::format("--scene={}", scene), "--", file});
    if (!verdict.accepts) {
        throw InputError(fmt::format("'{}' is not verified: {}", file, verdict.line));
    }
    Certificate certificate = read_certificate(file);
    if (digest_in(verdict.line) != certificate.sha256) {
        throw InputError(fmt::format("'{}' was changed while it was verified and read", file));
    }
    return certificate;
}

}  // namespace dumbbell::collisions
