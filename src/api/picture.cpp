#include "dumbbell/picture.hpp"

#include "api/translate.hpp"
#include "base/error.hpp"
#include "collisions/reader.hpp"
#include "collisions/section.hpp"
#include "collisions/witness_orbit.hpp"
#include "flight/paper_bound.hpp"
#include "pictures/orbit.hpp"
#include "pictures/phase.hpp"
#include "pictures/staircase.hpp"
#include "starts/answer/reader.hpp"

namespace dumbbell::api {
inline namespace DUMBBELL_ABI {
namespace {

std::string orbit_of(const collisions::Piece& piece) {
    if (!piece.witness || piece.witness->total() > Count(pictures::most_drawn_collisions)) {
        throw dumbbell::InputError(piece.witness ? "the orbit has too many collisions for a picture"
                                                 : "no orbit was found that could be drawn");
    }
    const auto orbit = witness_orbit(*piece.witness, piece.q_lo, piece.bits);
    if (orbit.empty()) {
        throw dumbbell::InputError("the orbit cannot be enclosed with the precision of its certificate");
    }
    return pictures::orbit_svg(orbit, piece.q_lo);
}

}  // namespace

std::string picture(const Proof& proof) {
    return guarded([&] {
        const collisions::Certificate certificate =
            collisions::read_certificate({"the certificate", proof.certificate});
        const bool is_single = certificate.q_lo() == certificate.q_hi();
        if (certificate.system.rho || (is_single && !row_of(certificate.system.section).has_orbits)) {
            throw dumbbell::InputError("pictures are of orbits of the dumbbell, and of staircases");
        }
        if (is_single) {
            return orbit_of(certificate.pieces.front());
        }
        if (certificate.q_hi() > flight::paper_bound_limit()) {
            throw dumbbell::InputError("no picture reaches beyond the mass ratio 3e31");
        }
        return pictures::staircase_svg(certificate);
    });
}

std::string picture(const StartsProof& proof) {
    return guarded([&] {
        return pictures::phase_svg(starts::read_certificate({"the certificate", proof.certificate}));
    });
}

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
