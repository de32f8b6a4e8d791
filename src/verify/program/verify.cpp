#include "verify/program/verify.hpp"

#include "verify/core/certificate.hpp"
#include "verify/core/section.hpp"
#include "verify/input/bytes.hpp"
#include "verify/machine/decimals.hpp"

namespace dumbbell_verify {
namespace {

/// The first lines. Of what is wrong with the very first it also says what that means: it is another file.
Header header_of(Text& text) try { return read_header(text); } catch (Failure& failure) {
    if (failure.verdict == Verdict::rejected && text.line == 1 && failure.code != "encoding")
        failure.text += ": not a certificate, whose first line is `dumbbell-certificate 1`";
    throw;
}

/// What the file is and what was demanded instead, where the reader has found that they differ.
void name_both(Failure& failure, const Settings& settings, std::string_view scene, const std::string& claim) {
    const auto other = [&failure](const char* what, std::string_view is, const std::string& asked) {
        failure.text = "the " + std::string(what) + " is " + std::string(is) + ", and " + asked +
                       " was demanded (--" + what + ")";
    };
    const std::string asked(settings.demanded_scene());
    if (failure.code != "claim-not-proved") return;
    if (!asked.empty() && asked != scene) return other("scene", scene, asked);
    if (!settings.claim.empty() && settings.claim != claim) other("claim", claim, settings.claim);
}

/// What is left of the file, which has this header. A bound on N* is proved by numbers of collisions only.
Verified read_on(Text& text, const Request& settings, const Header& header) {
    const std::string& claim = header.claim;
    const ClaimKind* kind = claim_kind(claim);
    const std::string unknown = "unknown claim " + claim + std::string(built_without());
    if (!kind && claim != "collisions" && !built_without().empty()) text.unsupported(unknown);
    const bool is_of_starts = kind && kind->is_of_starts;
    if (settings.shares && !is_of_starts)
        throw Failure{Verdict::unreadable, text.line, "usage",
                      "--shares is about a box of initial conditions (dumbbell trace --subdivide), and this "
                      "file is about something else"};
    if (header.section && claim == "collisions") {
        Verified found{collisions(text, settings, *header.section), {}};
        if (settings.heavy_once && !found.heavy_once)
            text.reject("claim-not-proved", "not proved: the heavy mass hits the floor at most once");
        const mpq_class known = found.decided.value_or(0);
        const auto share = settings.numbers.find("decided");
        if (share != settings.numbers.end() && known < share->second.first)
            text.reject("claim-not-proved", "not proved: the number of collisions for a share " +
                                                to_string(share->second.first) + " of the bodies, only for " +
                                                decimals(known, false));
        return found;
    }
    if (!kind || header.section != (kind->is_of_section ? &turning() : nullptr)) text.unsupported(unknown);
    const Collisions& demand = settings.demand;
    const bool bounds = demand.ratios || demand.most || demand.least;
    if (demand.gap || demand.gaps_at_most || demand.rhos || settings.heavy_once ||
        (bounds && (settings.claim.empty() || !is_of_starts)))
        throw Failure{Verdict::unreadable, 0, "usage",
                      "what is demanded is about all trajectories, and this file's claim is " + claim +
                          (is_of_starts ? ": to ask about what it claims add --claim " + claim : "")};
    return kind->proof(text, settings);
}

}  // namespace

Verified verify(const std::string& path, const Request& request) {
    Bytes bytes(path);
    return verify(bytes, request);
}

Verified verify(Source& bytes, const Request& request) {
    Text text(bytes, request.budget);
    const Header header = header_of(text);
    try {
        return read_on(text, request, header);
    } catch (Failure& failure) {
        name_both(failure, request, header.section ? header.section->scene : "dumbbell", header.claim);
        throw;
    }
}

}  // namespace dumbbell_verify
