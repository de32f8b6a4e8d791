#include "verify/program/part.hpp"

#include <algorithm>

#include "verify/format/text.hpp"
#include "verify/program/version.hpp"

namespace dumbbell_verify {

Pieces parse_pieces(std::string_view text) {
    const std::size_t dash = std::min(text.find('-'), text.size());
    const std::string_view first = text.substr(0, dash),
                           last = dash < text.size() ? text.substr(dash + 1) : first;
    if (!is_natural(first, 18) || !is_natural(last, 18)) return {};
    const Pieces pieces{std::stoull(std::string(first)), std::stoull(std::string(last))};
    return 1 <= pieces.first && pieces.first <= pieces.last ? pieces : Pieces{};
}

Part part_of(const Proof& proof, const Settings& settings, const PieceSums& sums, const Pieces& pieces) {
    const Collisions& claim = proof.claim;
    const auto piece = [&](std::uint64_t number) { return claim.parts.at(number - claim.keep.first); };
    return {.pieces = pieces,
            .of = claim.pieces,
            .scene = settings.scene,
            .section = std::string(proof.section),
            .lo = piece(pieces.first).lo,
            .hi = piece(pieces.last).hi,
            .bounds = sums.of(pieces),
            .precision = settings.precision,
            .digest = proof.digest};
}

Fields fields(const Part& part) {
    const auto number = [](std::uint64_t n) { return std::to_string(n); };
    const Bounds& bounds = part.bounds;
    return {{{"pieces", number(part.pieces.first) + "-" + number(part.pieces.last)},
             {"of", number(part.of)},
             {"scene", part.scene},
             {"section", part.section},
             {"ratio", to_string(part.lo, part.hi)},
             {"upper", bounds.upper ? bounds.upper->get_str() : "none"},
             {"lower", bounds.lower.get_str()},
             {"gaps", number(bounds.gaps)},
             {"open", number(bounds.open)},
             {"precision", part.precision > 0 ? number(part.precision) : "none"},
             {"verifier", std::string(version)},
             {"sha256", part.digest}}};
}

std::string part_text(const Part& part) {
    std::string text;
    for (const auto& [name, value] : fields(part)) {
        if (!text.empty()) text += ' ';
        (text += name).append("=").append(value);
    }
    return text;
}

}  // namespace dumbbell_verify
