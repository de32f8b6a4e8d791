#include <algorithm>

#include "base/error.hpp"
#include "cli/commands/join_parts.hpp"
#include "collisions/claim.hpp"
#include "collisions/verified.hpp"
#include "collisions/writer.hpp"
#include "file/verifier_program.hpp"
#include "number/decimal.hpp"
#include "number/ratio_argument.hpp"

namespace dumbbell::cli {
namespace {

using collisions::Certificate;
using collisions::Piece;

class CertificateParts : public Parts {
  public:
    CertificateParts(std::size_t files, const std::optional<Rational>& gap)
        : Parts(Content::certificate),
          certificates_(files),
          claims_(files, collisions::Claim{.gap = 0}),
          gap_(gap) {}

    [[nodiscard]] PartFile take(std::size_t i, const std::string& name, int jobs) override {
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

    [[nodiscard]] SealedText join(const std::vector<PartFile>& files) override {
        const Certificate& one = certificates_[files.front().number];
        std::vector<const Piece*> pieces;
        for (const PartFile& file : files) {
            for (const Piece& piece : certificates_[file.number].pieces) {
                pieces.push_back(&piece);
            }
        }
        return render(Certificate{.pieces = {}, .system = one.system}, pieces);
    }

    [[nodiscard]] Range parse_range(const std::string& text, const std::string& part) const override {
        const auto claim = collisions::claim_in(part);
        if (claim && claim->system.rho) {
            const collisions::Range inertia = collisions::parse_range("--range", text);
            return {inertia.lo, inertia.hi};
        }
        const RatioArgument ratio = parse_ratio_argument(text);
        return {ratio.lo, ratio.hi};
    }
    [[nodiscard]] std::string first(const Range& range) const override { return exact_text(range.begin); }
    [[nodiscard]] std::string last(const Range& range) const override { return exact_text(range.end); }

    [[nodiscard]] std::string what() const override {
        const bool bodies = std::ranges::any_of(
            claims_, [](const collisions::Claim& claim) { return claim.system.rho.has_value(); });
        return bodies ? "Q from" : "the mass ratios";
    }
    /// By default with the widest gap of all parts.
    [[nodiscard]] std::string command(const Range& range, const PartFile* like) const override {
        collisions::Claim claim = like == nullptr ? collisions::Claim{} : claims_[like->number];
        claim.range = {range.begin, range.end};
        claim.gap = gap_ ? *gap_ : std::ranges::max(claims_, {}, &collisions::Claim::gap).gap;
        return collisions::command(claim);
    }

  private:
    void tell(PartFile& file, const collisions::Claim& claim) {
        file.range = Range{claim.range.lo, claim.range.hi};
        file.kind = collisions::command({{1, 2}, claim.system});
        claims_[file.number] = claim;
    }

    std::vector<Certificate> certificates_;
    std::vector<collisions::Claim> claims_;
    std::optional<Rational> gap_;
};

}  // namespace

std::unique_ptr<Parts> certificate_parts(std::size_t files, const std::optional<Rational>& gap) {
    return std::make_unique<CertificateParts>(files, gap);
}

}  // namespace dumbbell::cli
