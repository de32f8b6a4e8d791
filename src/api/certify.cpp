#include "dumbbell/certify.hpp"

#include "api/caller_stops.hpp"
#include "api/checked.hpp"
#include "api/exact_ratio.hpp"
#include "api/translate.hpp"
#include "collisions/body/given.hpp"
#include "collisions/certify.hpp"
#include "collisions/demand.hpp"
#include "collisions/reader.hpp"
#include "collisions/scene.hpp"
#include "collisions/writer.hpp"
#include "file/atomic_file.hpp"
#include "number/parallel.hpp"
#include "number/ratio_argument.hpp"

namespace dumbbell::api {
inline namespace DUMBBELL_ABI {
namespace {

constexpr bool are_same(auto ours, auto theirs) { return static_cast<int>(ours) == static_cast<int>(theirs); }
static_assert(are_same(Section::turning, collisions::Section::turning) &&
              are_same(Section::full, collisions::Section::full) &&
              are_same(Section::plain, collisions::Section::plain) &&
              are_same(Scene::hybrid, collisions::Scene::hybrid) &&
              are_same(Scene::wedge, collisions::Scene::wedge) &&
              are_same(Scene::body, collisions::Scene::body));

collisions::CertifyRequest with(const CertifyOptions& options, collisions::CertifyRequest request) {
    request.gap = parse_gap(options.gap);
    request.jobs = checked_jobs(options.jobs);
    request.budget = options.budget;
    request.describes = false;
    const auto heights = request.heights.value_or(collisions::Heights{1, 1});
    for (const Rational& number : {request.q_lo, request.q_hi, heights.lo, heights.hi}) {
        // Two of them are in one line of a certificate, of 4096 bytes at most; and MassRatio takes what comes
        // back.
        if (to_fraction(number).size() > 2040) {
            throw dumbbell::InputError(
                "a number of the claim has too many digits for a certificate: its fraction is longer than "
                "2040 characters");
        }
    }
    return request;
}

collisions::CertifyRequest request_of(const MassRatio& ratio, const CertifyOptions& options) {
    collisions::CertifyRequest request;
    request.q_lo = exact_ratio(ratio.lo());
    request.q_hi = exact_ratio(ratio.hi());
    request.scene = static_cast<collisions::Scene>(options.scene);
    request.section = static_cast<collisions::Section>(options.section);
    if (options.scene == Scene::body || row_of(request.scene).charts(request.section).empty()) {
        throw dumbbell::InputError(
            "a mass ratio is of the dumbbell, or of a wedge in the section turning; a body has rho and "
            "inertia");
    }
    return with(options, request);
}

collisions::CertifyRequest request_of(const Body& body, const CertifyOptions& options) {
    if (options.section == Section::full ||
        (options.scene != Scene::dumbbell && options.scene != Scene::body)) {
        throw dumbbell::InputError("bodies are of the scene body, without a section");
    }
    return with(options, collisions::body_of(body.rho, body.inertia));
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
    proof.scene = static_cast<Scene>(certificate.scene);
    if (certificate.heights) {
        proof.rho_lo = to_fraction(certificate.heights->lo);
        proof.rho_hi = to_fraction(certificate.heights->hi);
    }
    return proof;
}

Proof proof_of(const collisions::CertifyRequest& request, const Stopped& stopped) {
    const CallerStops stops(stopped);
    collisions::Certificate certificate{
        .pieces = {}, .scene = request.scene, .section = request.section, .heights = request.heights};
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
        const auto body = collisions::body_of_rod(single_ratio(ends, "a rod with mass"),
                                                  parse_number("mass", std::string(mass)));
        return {to_fraction(body.heights->lo), to_fraction(body.q_lo)};
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
    });
}

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
