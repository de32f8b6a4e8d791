#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collisions/claim.hpp"
#include "collisions/part.hpp"
#include "collisions/witness.hpp"
#include "flight/orbit.hpp"
#include "words/json.hpp"

namespace dumbbell::collisions {

struct ReportRow {
    const Piece* piece;
    double margin;  ///< of the witness orbit; 0: none known, nor a width
    double width;
    double seconds;
    std::vector<flight::Collision<Interval>>
        orbit;  ///< of the witness, at the piece's lower end; empty unless asked for
    std::optional<WitnessStart> start =
        std::nullopt;  ///< in the air, of an orbit with as many collisions there
    /// Where one was asked for.
    std::string why_no_start = {};
};

/// What `certify` tells its user, as text or as JSON (the contract's object).
struct ProofReport {
    Claim claim;
    std::optional<RatioPart> part{};  ///< where only that was asked for
    int jobs;
    double seconds;
    Rational undecided;  ///< share of the range
    std::vector<ReportRow> rows{};
    std::optional<std::string> out{};
    std::optional<std::string> sha256{};
};

/// One sentence that says what was proved, and a table: ratio interval, N, the paper's bound (for the
/// dumbbell, of which it is one), boxes, time. Ratios are exact.
[[nodiscard]] std::string to_text(const ProofReport& report);
[[nodiscard]] Json to_json(const ProofReport& report);

/// That sentence alone.
[[nodiscard]] std::string verdict(const ProofReport& report);

/// The orbits of the rows that have one: per collision mass, time, phi, height and velocities, enclosed.
[[nodiscard]] std::string orbits_to_text(const ProofReport& report);

}  // namespace dumbbell::collisions
