#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "dumbbell/stopped.hpp"

/// The independent verifier: it shares no code with the prover of dumbbell/certify.hpp.
namespace dumbbell::api {
inline namespace DUMBBELL_ABI {

/// What a certificate has to prove: for every mass ratio of `ratio` (`10`, `9/2`, `1:100`) no trajectory has
/// more than `most` collisions, and some trajectory has `least`. Of neither: any bound for all of `ratio`.
/// An empty `ratio` is the file's own range. Of another `kind` (initial-conditions, incoming, law and so on,
/// as for `dumbbell-verify --claim`) what it says there; without one it is collisions, and an empty one is
/// the file's own kind. `demand` has whatever else is claimed, with blanks between, as options of
/// dumbbell-verify: `--gap 1e-6 --gaps 8`, or all of the claim, `--coin --exactly 4`.
struct Claim {
    std::string ratio = {};
    std::optional<std::uint64_t> most = std::nullopt;
    std::optional<std::uint64_t> least = std::nullopt;
    std::optional<std::string> kind = std::nullopt;
    std::string demand = {};
};

enum class Verdict {
    verified,     ///< all that the file says is certified, and it proves the claim
    rejected,     ///< the file is wrong or damaged, or does not prove the claim
    unsupported,  ///< another format version, claim kind, scene, section or lemma set
    unreadable,   ///< there is no such file
    limit,        ///< it needs more work, memory, threads or precision than it may have; or it was stopped
    open          ///< all that the file says is certified, but it bounds nothing, and no bound was asked for
};

struct Verification {
    Verdict verdict = Verdict::rejected;
    std::string text;    ///< one line: what the file proves, with its SHA-256, or what is wrong, and where
    std::string sha256;  ///< of a verified file

    /// Whether it is verified.
    explicit operator bool() const noexcept { return verdict == Verdict::verified; }
};

/// Verifies a certificate (.dbc, also gzip-compressed) on up to `jobs` threads, with as much work as takes a
/// core about the time of `budget` (`30s`, `10m`, `2h`). Where a claim is stated it is about the dumbbell,
/// unless it says another scene or a body. Throws std::invalid_argument, with a message that says what to do,
/// if the claim is none (`ratio` is no mass ratio, a part of `demand` states nothing, or does not fit the
/// kind), for jobs = 0, and for a name with a NUL.
[[nodiscard]] [[gnu::visibility("default")]] Verification verify(const std::string& file, const Claim& claim,
                                                                 unsigned jobs = 1,
                                                                 const std::string& budget = "30s",
                                                                 const Stopped& stopped = {});

/// The same of a text in memory: what the file would hold, plain or gzip-compressed.
[[nodiscard]] [[gnu::visibility("default")]] Verification verify_text(std::string_view text,
                                                                      const Claim& claim, unsigned jobs = 1,
                                                                      const std::string& budget = "30s",
                                                                      const Stopped& stopped = {});

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
