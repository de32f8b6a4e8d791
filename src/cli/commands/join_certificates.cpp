#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "cli/commands/join_parts.hpp"
#include "collisions/certify.hpp"
#include "collisions/names.hpp"
#include "collisions/proof_report.hpp"
#include "collisions/verified.hpp"
#include "collisions/writer.hpp"
#include "file/verifier_program.hpp"
#include "number/decimal.hpp"
#include "number/ratio_argument.hpp"

namespace dumbbell::cli {
namespace {

using collisions::Certificate;

std::string options_of(collisions::Scene scene, collisions::Section section) {
    using collisions::Section;
    return fmt::format("{}{}{}", scene == collisions::Scene::dumbbell ? "" : " --scene ",
                       scene == collisions::Scene::dumbbell ? "" : name(scene),
                       section == Section::turning ? ""
                       : section == Section::full  ? " --section full"
                                                   : " --section plain");
}

class CertificateParts : public Parts {
  public:
    CertificateParts(std::size_t files, std::string gap) : certificates_(files), gap_(std::move(gap)) {}

    [[nodiscard]] Content content() const override { return Content::certificate; }

    [[nodiscard]] Range parse_range(const std::string& text) const override {
        const RatioArgument ratio = parse_ratio_argument(text);
        return {ratio.lo, ratio.hi};
    }

    [[nodiscard]] PartFile take(std::size_t i, const std::string& name, int jobs,
                                const Interrupted& /*the verifier ends with this program*/) override {
        PartFile file{name};
        if (const auto claimed = collisions::claimed_range(name)) {
            file.range = Range{claimed->q_lo, claimed->q_hi};
            file.options = options_of(claimed->scene, claimed->section);
        }
        try {
            Certificate& certificate = certificates_[i] = collisions::verified_certificate(name, jobs);
            file.range = Range{certificate.q_lo(), certificate.q_hi()};
            file.options = options_of(certificate.scene, certificate.section);
            file.pieces = certificate.pieces.size();
            file.open = static_cast<std::size_t>(
                std::ranges::count(certificate.pieces, collisions::Status::open, &collisions::Piece::status));
        } catch (const NoVerdict&) {
            throw;
        } catch (const InputError& error) {
            file.fault = error.what();
        }
        return file;
    }

    [[nodiscard]] std::string words(const Range& range) const override {
        return fmt::format("the mass ratios {} to {}", exact_text(range.begin), exact_text(range.end));
    }

    [[nodiscard]] Json range_json(const Range& range) const override {
        return Json::object({{"lo", to_fraction(range.begin)}, {"hi", to_fraction(range.end)}});
    }

    [[nodiscard]] std::string command(const Range& range, const std::string& options) const override {
        return fmt::format("dumbbell certify {}:{}{} --gap {}", exact_text(range.begin),
                           exact_text(range.end), options, gap_);
    }

    [[nodiscard]] Joined join(const std::vector<std::size_t>& order) override {
        std::vector<collisions::ProvedPiece> proved;
        for (const std::size_t i : order) {
            for (collisions::Piece& piece : certificates_[i].pieces) {
                proved.emplace_back().piece = std::move(piece);
            }
        }
        const Certificate frame{.pieces = {},
                                .scene = certificates_[order.front()].scene,
                                .section = certificates_[order.front()].section};
        collisions::ProofReport report;
        report.scene = frame.scene;
        report.section = frame.section;
        report.q_lo = proved.front().piece.q_lo;
        report.q_hi = proved.back().piece.q_hi;
        report.undecided = undecided_share(proved);
        std::vector<const collisions::Piece*> pieces;
        for (const collisions::ProvedPiece& p : proved) {
            pieces.push_back(&p.piece);
            report.rows.push_back({.piece = &p.piece, .margin = 0, .width = 0, .seconds = 0, .orbit = {}});
        }
        return {render(frame, pieces), verdict(report)};
    }

  private:
    std::vector<Certificate> certificates_;
    std::string gap_;
};

}  // namespace

std::unique_ptr<Parts> certificate_parts(std::size_t files, std::string gap) {
    return std::make_unique<CertificateParts>(files, std::move(gap));
}

}  // namespace dumbbell::cli
