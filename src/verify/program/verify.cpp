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
Verified about(std::pair<Proof, Claim> found) {
    return {std::move(found.first), std::move(found.second)};
}

}  // namespace

Verified verify(const std::string& path, const Settings& settings) {
    Text text(path, settings.budget);
    const Header header = read_header(text);
    const std::string& claim = header.claim;
    const bool incoming = claim == "incoming", is_initial = incoming || claim == "initial-conditions";
    if (settings.shares && !is_initial)
        throw Failure{Verdict::unreadable, text.line, "usage",
                      "--shares is about a box of initial conditions (dumbbell trace --subdivide), and this "
                      "file is about something else"};
    if (header.section && claim == "collisions") return {collisions(text, settings, *header.section), {}};
    const auto invariant = adiabatic_kind(claim);
    const bool is_law = header.section == &turning() && claim == "law", is_by_law = claim == LawAtRatio::kind;
    if (!is_law && (header.section || !(invariant || is_by_law || is_initial)))
        text.unsupported("unknown claim " + claim);
    if (settings.check != all_pieces)
        throw Failure{Verdict::unreadable, text.line, "usage",
                      "a file with this claim has no pieces: it is verified as a whole only"};
    if (is_law) return about(law(text, settings));
    if (is_by_law) return about(law_at_ratio(text, settings));
    if (invariant) return about(adiabatic(text, settings, *invariant));
    return about(initial(text, settings, incoming));
}

}  // namespace dumbbell_verify
