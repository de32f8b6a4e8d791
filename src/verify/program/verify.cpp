#include "verify/program/verify.hpp"

#include "verify/adiabatic/grammar.hpp"
#include "verify/collisions/grammar.hpp"
#include "verify/format/header.hpp"
#include "verify/law/grammar.hpp"
#include "verify/starts/grammar.hpp"

namespace dumbbell_verify {

Verified verify(const std::string& path, const Settings& settings) {
    Text text(path, settings.budget);
    const Header header = read_header(text);
    if (header.section && header.claim == "collisions")
        return {collisions(text, settings, *header.section), {}, {}, {}};
    const auto invariant = adiabatic_kind(header.claim);
    const bool is_law = header.section == &turning() && header.claim == "law";
    if (!is_law && (header.section || !(invariant || header.claim == "initial-conditions")))
        text.unsupported("unknown claim " + header.claim);
    if (settings.check != all_pieces)
        throw Failure{Verdict::unreadable, text.line, "usage",
                      "a file with this claim has no pieces: it is verified as a whole only"};
    if (is_law) {
        auto [proof, claim] = law(text, settings);
        return {std::move(proof), {}, {}, std::move(claim)};
    }
    if (invariant) {
        auto [proof, claim] = adiabatic(text, settings, *invariant);
        return {std::move(proof), {}, std::move(claim), {}};
    }
    auto [proof, claim] = initial(text, settings);
    return {std::move(proof), std::move(claim), {}, {}};
}

}  // namespace dumbbell_verify
