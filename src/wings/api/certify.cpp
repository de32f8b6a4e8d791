#include "dumbbell/certify.hpp"

#include <array>

#include "api/caller_stops.hpp"
#include "api/checked.hpp"
#include "api/exact_ratio.hpp"
#include "api/translate.hpp"
#include "collisions/certify.hpp"
#include "collisions/reader.hpp"
#include "collisions/section.hpp"
#include "collisions/writer.hpp"
#include "file/atomic_file.hpp"
#include "number/parallel.hpp"
#include "number/ratio_argument.hpp"

namespace dumbbell::api {
inline namespace DUMBBELL_ABI {
namespace {

/// In the order of Section.
constexpr std::array<std::string_view, 3> sections{"turning", "full", "plain"};

collisions::CertifyRequest request_of(collisions::Claim claim, const CertifyOptions& options) {
    claim.gap = parse_gap(options.gap);
    for (const Rational& number : {claim.range.lo, claim.range.hi, claim.system.rho.value_or(1)}) {
        // Two of them are in one line of a certificate, of 4096 bytes at most; and MassRatio takes what comes
        // back.
        if (to_fraction(number).size() > 2040) {
            throw dumbbell::InputError(
                "a number of the claim has too many digits for a certificate: its fraction is longer than "
                "2040 characters");
        }
    }
    return {.claim = claim, .jobs = checked_jobs(options.jobs), .budget = options.budget, .describes = false};
}

collisions::CertifyRequest request_of(const MassRatio& ratio, const CertifyOptions& options) {
    const auto section =
        collisions::section_named("dumbbell", sections.at(static_cast<std::size_t>(options.section)));
    return request_of(
        {.range = {exact_ratio(ratio.lo()), exact_ratio(ratio.hi())}, .system = {section.value()}}, options);
}

collisions::CertifyRequest request_of(const Body& body, const CertifyOptions& options) {
    if (options.section == Section::full) {
        throw dumbbell::InputError("bodies are proved by perpendicular orbits, or in the section plain");
    }
    collisions::Claim claim = collisions::claim_of_body(body.rho, body.inertia);
    return request_of(options.section == Section::plain ? by_plain_covers(std::move(claim)) : claim, options);
}

Piece given(const collisions::Piece& piece) {
    const auto most = piece.upper ? std::optional(as_long(*piece.upper)) : std::nullopt;
    return {to_fraction(piece.q_lo), to_fraction(piece.q_hi), as_long(piece.lower), most};
}

Proof proof_of(const collisions::Certificate& certificate, SealedText text) {
    Proof proof;
    for (const collisions::Piece& piece : certificate.pieces) {
        proof.pieces.push_back(given(piece));
    }
    proof.certificate = std::move(text.text);
    proof.sha256 = std::move(text.sha256);
    proof.demand = whole_demand(claim_of(certificate), pieces_of(certificate));
    if (const auto& rho = certificate.system.rho) {
        proof.scene = Scene::body;
        proof.rho = to_fraction(*rho);
    }
    return proof;
}

Proof proof_of(const collisions::CertifyRequest& request, const Stopped& stopped) {
    const CallerStops stops(stopped);
    collisions::Certificate certificate{.pieces = {}, .system = request.claim.system};
    for (collisions::ProvedPiece& proved : dumbbell::collisions::certify(request)) {
        certificate.pieces.push_back(std::move(proved.piece));
    }
    return proof_of(certificate, render(certificate));
}

}  // namespace

Proof certify(const MassRatio& ratio, const CertifyOptions& options) {
    return guarded([&] { return proof_of(request_of(ratio, options), options.stopped); });
}

Proof certify(const Body& body, const CertifyOptions& options) {
    return guarded([&] { return proof_of(request_of(body, options), options.stopped); });
}

Body body_of_rod(const MassRatio& ends, std::string_view mass) {
    return guarded([&]() -> Body {
        const auto body = claim_of(
            collisions::Rod{single_ratio(ends, "a rod with mass"), parse_number("mass", std::string(mass))});
        return {to_fraction(*body.system.rho), to_fraction(body.range.lo)};
    });
}

std::vector<Proof> certify_many(std::span<const MassRatio> ratios, const CertifyOptions& options) {
    return guarded([&] {
        std::vector<Proof> proofs(ratios.size());
        CertifyOptions each = options;
        each.jobs = 1;
        run_with_threads(checked_jobs(options.jobs), [&] {
            in_parallel(ratios.size(), [&](std::size_t i) {
                proofs[i] = proof_of(request_of(ratios[i], each), options.stopped);
            });
        });
        return proofs;
    });
}

Proof read_proof(std::string_view text) {
    return guarded([&] {
        const NamedFile source("the certificate", text);
        const collisions::Certificate certificate = collisions::read_certificate(source);
        if (certificate.sha256.empty()) {
            throw dumbbell::InputError("the certificate is damaged");
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
        return true;
    });
}

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
