#include "dumbbell/picture.hpp"

#include "api/translate.hpp"
#include "base/error.hpp"
#include "collisions/reader.hpp"
#include "pictures/orbit.hpp"
#include "pictures/phase.hpp"
#include "pictures/staircase.hpp"
#include "starts/answer/reader.hpp"

namespace dumbbell::api {
inline namespace DUMBBELL_ABI {

std::string picture(const Proof& proof) {
    return guarded([&] {
        const collisions::Certificate certificate =
            collisions::read_certificate({"the certificate", proof.certificate});
        if (certificate.system.rho) {
            throw dumbbell::InputError("pictures are of orbits of the dumbbell, and of staircases");
        }
        return certificate.q_lo() == certificate.q_hi()
                   ? pictures::orbit_svg(certificate.pieces.front(), certificate.q_lo())
                   : pictures::staircase_svg(certificate);
    });
}

std::string picture(const StartsProof& proof) {
    return guarded([&] {
        return pictures::phase_svg(starts::read_certificate({"the certificate", proof.certificate}));
    });
}

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
