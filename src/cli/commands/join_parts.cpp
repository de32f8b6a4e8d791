#include "cli/commands/join_parts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "collisions/verified.hpp"
#include "collisions/writer.hpp"
#include "file/verifier_program.hpp"
#include "number/decimal.hpp"
#include "number/ratio_argument.hpp"

namespace dumbbell::cli {

using collisions::Certificate;
using collisions::Claim;
using collisions::Piece;
using collisions::Range;

Parts::Parts(std::size_t files, std::optional<Rational> gap)
    : certificates_(files), claims_(files, Claim{.gap = 0}), gap_(std::move(gap)) {}

void Parts::tell(PartFile& file, const Claim& claim) {
    file.range = claim.range;
    file.kind = collisions::command({{1, 2}, claim.system});
    claims_[file.number] = claim;
}

PartFile Parts::take(std::size_t i, const std::string& name, int jobs) {
    PartFile file{name, i};
    try {
        if (const auto claimed = collisions::claim_in(name)) {
            tell(file, *claimed);
        }
        const Certificate& certificate = certificates_[i] = collisions::verified_certificate(name, jobs);
        tell(file, claim_of(certificate));
        file.pieces = certificate.pieces.size();
        file.open = static_cast<std::size_t>(
            std::ranges::count(certificate.pieces, collisions::Status::open, &Piece::status));
    } catch (const NoVerdict&) {
        throw;
    } catch (const InputError& error) {
        file.fault = error.what();
    }
    return file;
}

SealedText Parts::join(const std::vector<PartFile>& files) const {
    const Certificate& one = certificates_[files.front().number];
    std::vector<const Piece*> pieces;
    for (const PartFile& file : files) {
        for (const Piece& piece : certificates_[file.number].pieces) {
            pieces.push_back(&piece);
        }
    }
    return render(Certificate{.pieces = {}, .system = one.system}, pieces);
}

std::string Parts::words(const Range& range) const {
    const bool bodies =
        std::ranges::any_of(claims_, [](const Claim& claim) { return claim.system.rho.has_value(); });
    return fmt::format("{} {} to {}", bodies ? "Q from" : "the mass ratios", exact_text(range.lo),
                       exact_text(range.hi));
}

std::string Parts::command(const Range& range, const PartFile* like) const {
    Claim claim = like == nullptr ? Claim{} : claims_[like->number];
    claim.range = range;
    claim.gap = gap_ ? *gap_ : std::ranges::max(claims_, {}, &Claim::gap).gap;
    return collisions::command(claim);
}

Range parse_range(const std::string& text, const std::string& part) {
    const auto claim = collisions::claim_in(part);
    if (claim && claim->system.rho) {
        return collisions::parse_range("--range", text);
    }
    const RatioArgument ratio = parse_ratio_argument(text);
    return {ratio.lo, ratio.hi};
}

}  // namespace dumbbell::cli
