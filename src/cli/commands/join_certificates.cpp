#include <fmt/core.h>

#include <algorithm>

#include "base/error.hpp"
#include "cli/commands/join_parts.hpp"
#include "collisions/names.hpp"
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
    CertificateParts(std::size_t files, const std::string& gap)
        : Parts(Content::certificate, "the mass ratios", "dumbbell certify"),
          certificates_(files),
          gap_(gap) {}

    [[nodiscard]] PartFile take(std::size_t i, const std::string& name, int jobs) override {
        PartFile file{name, i};
        try {
            if (const auto claimed = collisions::claimed_range(name)) {
                file.range = Range{claimed->q_lo, claimed->q_hi};
                file.options = options(claimed->scene, claimed->section);
            }
            Certificate& certificate = certificates_[i] = collisions::verified_certificate(name, jobs);
            if (certificate.heights) {
                file.range.reset();
                throw InputError(
                    fmt::format("'{}' is about rigid bodies, which have no parts: leave it out", name));
            }
            file.range = Range{certificate.q_lo(), certificate.q_hi()};
            file.options = options(certificate.scene, certificate.section);
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
        return render(Certificate{.pieces = {}, .scene = one.scene, .section = one.section}, pieces);
    }

    [[nodiscard]] Range parse_range(const std::string& text) const override {
        const RatioArgument ratio = parse_ratio_argument(text);
        return {ratio.lo, ratio.hi};
    }
    [[nodiscard]] std::string first(const Range& range) const override { return exact_text(range.begin); }
    [[nodiscard]] std::string last(const Range& range) const override { return exact_text(range.end); }

  private:
    [[nodiscard]] static std::string options(collisions::Scene scene, collisions::Section section) {
        return (scene == collisions::Scene() ? "" : fmt::format(" --scene {}", name(scene))) +
               (section == collisions::Section() ? "" : fmt::format(" --section {}", name(section)));
    }
    [[nodiscard]] std::string gap_option() const override {
        std::string gap = gap_;
        Rational widest = 0;
        for (const Certificate& certificate : certificates_) {
            for (const Piece& piece : certificate.pieces) {
                if (piece.status() == collisions::Status::gap) {
                    widest = std::max(widest, Rational((piece.q_hi - piece.q_lo) / piece.q_lo));
                }
            }
        }
        if (gap.empty() && widest > 0 && widest <= Rational(1, 100)) {
            gap = to_text(cut_up(widest, 1));
        }
        return gap.empty() ? "" : " --gap " + gap;
    }

    std::vector<Certificate> certificates_;
    std::string gap_;
};

}  // namespace

std::unique_ptr<Parts> certificate_parts(std::size_t files, const std::string& gap) {
    return std::make_unique<CertificateParts>(files, gap);
}

}  // namespace dumbbell::cli
