#include "dumbbell/certify.hpp"

#include "api/exact_ratio.hpp"
#include "api/translate.hpp"
#include "collisions/certify.hpp"
#include "collisions/writer.hpp"
#include "file/atomic_file.hpp"
#include "number/ratio_argument.hpp"

namespace dumbbell::api {
inline namespace DUMBBELL_ABI {
namespace {

collisions::CertifyRequest request_of(const MassRatio& ratio, const CertifyOptions& options) {
    if (options.jobs < 1 || options.jobs > 1024) {
        throw dumbbell::InputError("jobs is out of range: give a number of threads from 1 to 1024");
    }
    collisions::CertifyRequest request;
    request.q_lo = exact_ratio(ratio.lo());
    request.q_hi = exact_ratio(ratio.hi());
    request.gap = parse_gap(options.gap);
    request.jobs = options.jobs;
    request.budget = options.budget;
    request.describes = false;
    return request;
}

}  // namespace

Proof certify(const MassRatio& ratio, const CertifyOptions& options) {
    return guarded([&] {
        collisions::Certificate certificate;
        Proof proof;
        for (collisions::ProvedPiece& proved : dumbbell::collisions::certify(request_of(ratio, options))) {
            const dumbbell::collisions::Piece& piece =
                certificate.pieces.emplace_back(std::move(proved.piece));
            const auto most = piece.upper ? std::optional(as_long(*piece.upper)) : std::nullopt;
            proof.pieces.push_back(
                {to_fraction(piece.q_lo), to_fraction(piece.q_hi), as_long(piece.lower), most});
        }
        SealedText text = render(certificate);
        proof.certificate = std::move(text.text);
        proof.sha256 = std::move(text.sha256);
        return proof;
    });
}

void save(const Proof& proof, const std::string& file) {
    guarded([&] {
        if (file.empty()) {
            throw dumbbell::InputError("the file name is empty");
        }
        write_atomically(output_target(file), proof.certificate);
    });
}

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
