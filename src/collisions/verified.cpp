#include "collisions/verified.hpp"

#include <fmt/core.h>

#include "base/error.hpp"
#include "collisions/names.hpp"
#include "collisions/reader.hpp"
#include "file/verifier_program.hpp"

namespace dumbbell::collisions {

std::optional<ClaimedRange> claimed_range(const std::string& file) try {
    const ClaimedHead head = read_head(file);
    return head.q_lo < 1 || head.q_lo > head.q_hi
               ? std::nullopt
               : std::optional(ClaimedRange{head.scene, head.section, head.q_lo, head.q_hi});
} catch (const InputError&) {
    return std::nullopt;
}

Certificate verified_certificate(const std::string& file, int jobs) {
    const Scene scene = read_head(file).scene;
    // A user who waits for it can stop it; a budget would only be in the way.
    const Verdict verdict =
        ask_verifier({fmt::format("--jobs={}", jobs), "--quiet", "--budget=99999h", "--max-bits=4096",
                      fmt::format("--scene={}", name(scene)), "--", file});
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
