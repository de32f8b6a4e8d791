#include "dumbbell/certify.hpp"

#include <algorithm>

#include "api/caller_stops.hpp"
#include "api/exact_ratio.hpp"
#include "api/jobs.hpp"
#include "api/translate.hpp"
#include "collisions/certify.hpp"
#include "collisions/demand.hpp"
#include "collisions/reader.hpp"
#include "collisions/writer.hpp"
#include "file/atomic_file.hpp"
#include "number/parallel.hpp"
#include "number/ratio_argument.hpp"

namespace dumbbell::api {
inline namespace DUMBBELL_ABI {
namespace {

collisions::Section section_of(Section section) {
    return section == Section::turning ? collisions::Section::turning
           : section == Section::full  ? collisions::Section::full
                                       : collisions::Section::plain;
}

collisions::CertifyRequest request_of(const MassRatio& ratio, const CertifyOptions& options) {
    collisions::CertifyRequest request;
    request.q_lo = exact_ratio(ratio.lo());
    request.q_hi = exact_ratio(ratio.hi());
    // Two of them are in one line of a certificate, of 4096 bytes at most; and MassRatio takes what comes
    // back.
    if (std::max(ratio.lo().size(), ratio.hi().size()) > 2040) {
        throw dumbbell::InputError(
            "the mass ratio has too many digits for a certificate: its fraction is longer "
            "than 2040 characters");
    }
    request.gap = parse_gap(options.gap);
    request.section = section_of(options.section);
    request.jobs = checked_jobs(options.jobs);
    request.budget = options.budget;
    request.describes = false;
    return request;
}

Piece given(const collisions::Piece& piece) {
    const auto most = piece.upper ? std::optional(as_long(*piece.upper)) : std::nullopt;
    return {to_fraction(piece.q_lo), to_fraction(piece.q_hi), as_long(piece.lower), most};
}

Proof proof_of(const collisions::Certificate& certificate, SealedText text) {
    Proof proof;
    std::vector<const collisions::Piece*> pieces;
    for (const collisions::Piece& piece : certificate.pieces) {
        proof.pieces.push_back(given(piece));
        pieces.push_back(&piece);
    }
    proof.certificate = std::move(text.text);
    proof.sha256 = std::move(text.sha256);
    proof.demand = whole_demand(certificate, pieces);
    return proof;
}

Proof proof_of(const MassRatio& ratio, const CertifyOptions& options) {
    const CallerStops stops(options.stopped);
    const collisions::CertifyRequest request = request_of(ratio, options);
    collisions::Certificate certificate;
    certificate.section = request.section;
    for (collisions::ProvedPiece& proved : dumbbell::collisions::certify(request)) {
        certificate.pieces.push_back(std::move(proved.piece));
    }
    return proof_of(certificate, render(certificate));
}

}  // namespace

Proof certify(const MassRatio& ratio, const CertifyOptions& options) {
    return guarded([&] { return proof_of(ratio, options); });
}

std::vector<Proof> certify_many(std::span<const MassRatio> ratios, const CertifyOptions& options) {
    return guarded([&] {
        std::vector<Proof> proofs(ratios.size());
        CertifyOptions each = options;
        each.jobs = 1;
        run_with_threads(checked_jobs(options.jobs), [&] {
            in_parallel(ratios.size(), [&](std::size_t i) { proofs[i] = proof_of(ratios[i], each); });
        });
        return proofs;
    });
}

Proof read_proof(std::string_view text) {
    return guarded([&] {
        const NamedFile source("the certificate", text);
        const collisions::Certificate certificate = collisions::read_certificate(source);
        if (certificate.scene != collisions::Scene::dumbbell || certificate.sha256.empty()) {
            throw dumbbell::InputError("the certificate is damaged, or not about N(q)");
        }
        std::string unpacked;
        UnpackedText lines(source);
        for (auto line = lines.next_line(); !line.empty(); line = lines.next_line()) {
            unpacked += line;
        }
        return proof_of(certificate, {std::move(unpacked), certificate.sha256});
    });
}

void save(const Proof& proof, const std::string& file) {
    guarded([&] {
        if (file.empty() || file.find('\0') != std::string::npos) {
            throw dumbbell::InputError("the file name is empty, or has a NUL in it");
        }
        write_atomically(output_target(file), proof.certificate);
    });
}

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
