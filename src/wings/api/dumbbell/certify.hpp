#pragma once

#include <algorithm>
#include <chrono>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dumbbell/mass_ratio.hpp"
#include "dumbbell/stopped.hpp"

/// Proofs of the greatest number of floor collisions, N(q), as certificates that dumbbell/verify.hpp
/// re-checks.
namespace dumbbell::api {
inline namespace DUMBBELL_ABI {

enum class Scene { dumbbell, body };

/// What a certificate covers: the turning collisions and the contacts with the bridge, or all collision
/// states (`plain`: without monotonicity), up to ratios of about 1000. N(q) is the same.
enum class Section { turning, full, plain };

struct CertifyOptions {
    std::string gap = "1e-6";  ///< ranges: relative width of the gap around a critical ratio, 1e-300 to 0.01
    int jobs = 1;              ///< threads, 1 to 1024; the result does not depend on it
    std::optional<std::chrono::duration<double>> budget =
        std::nullopt;                    ///< what is not decided by then is left open
    Section section = Section::turning;  ///< of the dumbbell; of a body plain, or else its tangents
    Stopped stopped = {};
};

/// Rigid bodies that move in a plane (proofs/body.md): rho = d2/d1 of the distances of the contacts from the
/// centre of mass, a number, and inertia Q = (d1/k)^2, k the radius of gyration, a number or LO:HI; as
/// written. A thin coin is {"1", "4"}, a uniform rod {"1", "3"}.
struct Body {
    std::string rho;
    std::string inertia;
};

/// The dumbbell whose uniform rod has `mass` times the mass of both ends. Throws InputError for a range.
[[nodiscard]] [[gnu::visibility("default")]] Body body_of_rod(const MassRatio& ends, std::string_view mass);

/// For every mass ratio q of [lo, hi] (fractions, as MassRatio::lo(); of bodies their Q): least <= N(q) and,
/// if given, N(q) <= most. Both are equal, or differ by one in a gap around a critical ratio, or the piece is
/// open: no `most`.
struct Piece {
    std::string lo;
    std::string hi;
    long least = 0;
    std::optional<long> most;
};

struct Proof {
    std::vector<Piece> pieces;  ///< in order, each begins where the one before ends
    std::string certificate;    ///< the text of the file that proves them (format.md)
    std::string sha256;         ///< its last line's: of the text before it
    std::string demand;         ///< all that it says, as Claim::demand of dumbbell/verify.hpp
    Scene scene = Scene::dumbbell;
    std::string rho;  ///< of bodies: a fraction; else empty

    /// Whether no piece is open.
    [[nodiscard]] bool complete() const {
        return std::ranges::all_of(pieces, [](const Piece& piece) { return piece.most.has_value(); });
    }
    /// For every ratio of all pieces: least() <= N(q) <= most(). Precondition: there are pieces.
    [[nodiscard]] long least() const { return std::ranges::min(pieces, {}, &Piece::least).least; }
    [[nodiscard]] std::optional<long> most() const {
        return complete() ? std::ranges::max(pieces, {}, &Piece::most).most : std::nullopt;
    }
};

/// Proves the maximum for one mass ratio, or for every one of a range. What it claims rests on the
/// certificate: verify that. Throws InputError for an option out of range, a range with more than a million
/// steps, or a maximum beyond 2^63.
[[nodiscard]] [[gnu::visibility("default")]] Proof certify(const MassRatio& ratio,
                                                           const CertifyOptions& options = {});

/// The same for a body, or for all with a range of Q. Throws InputError, too, where there is none, for the
/// section plain where its mass is not between its contacts, and for the section full.
[[nodiscard]] [[gnu::visibility("default")]] Proof certify(const Body& body,
                                                           const CertifyOptions& options = {});

/// The same for each of many, in their order: `jobs` threads share them out.
[[nodiscard]] [[gnu::visibility("default")]] std::vector<Proof> certify_many(
    std::span<const MassRatio> ratios, const CertifyOptions& options = {});

/// What a certificate's text (plain or gzip-compressed) says of the maximum, to be drawn or saved: it is not
/// verified. Throws InputError if it is damaged, or about something else.
[[nodiscard]] [[gnu::visibility("default")]] Proof read_proof(std::string_view text);

/// Writes the certificate to a file, gzip-compressed if its name ends in `.gz`; the file appears complete or
/// not at all. Throws InputError, naming the file and the cause, if it cannot be written.
[[gnu::visibility("default")]] void save(const Proof& proof, const std::string& file);

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
