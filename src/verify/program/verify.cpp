#include "verify/program/verify.hpp"

#include "verify/adiabatic/grammar.hpp"
#include "verify/collisions/grammar.hpp"
#include "verify/format/header.hpp"
#include "verify/law/at_ratio.hpp"
#include "verify/law/grammar.hpp"
#include "verify/starts/grammar.hpp"

namespace dumbbell_verify {
namespace {

template <class Claim>
Verified with(std::optional<Claim> Verified::*place, std::pair<Proof, Claim> found) {
    Verified result{std::move(found.first), {}, {}, {}, {}};
    result.*place = std::move(found.second);
    return result;
}

}  // namespace

Verified verify(const std::string& path, const Settings& settings) {
    Text text(path, settings.budget);
    const Header header = read_header(text);
    const std::string& claim = header.claim;
    if (header.section && claim == "collisions")
        return {collisions(text, settings, *header.section), {}, {}, {}, {}};
    const auto invariant = adiabatic_kind(claim);
    const bool is_law = header.section == &turning() && claim == "law", is_by_law = claim == LawAtRatio::kind;
    if (!is_law && (header.section || !(invariant || is_by_law || claim == "initial-conditions")))
        text.unsupported("unknown claim " + claim);
    if (settings.check != all_pieces)
        throw Failure{Verdict::unreadable, text.line, "usage",
                      "a file with this claim has no pieces: it is verified as a whole only"};
    if (is_law) return with(&Verified::law, law(text, settings));
    if (is_by_law) return with(&Verified::by_law, law_at_ratio(text, settings));
    if (invariant) return with(&Verified::adiabatic, adiabatic(text, settings, *invariant));
    return with(&Verified::initial, initial(text, settings));
}

}  // namespace dumbbell_verify
