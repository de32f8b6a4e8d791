#include "law/prove.hpp"

#include "law/steps.hpp"
#include "number/parallel.hpp"
#include "number/self_test.hpp"

namespace dumbbell::law {

std::optional<LawCertificate> prove_law(const LawRequest& request) {
    require_sound_arithmetic();
    return with_threads(request.jobs, [&]() -> std::optional<LawCertificate> {
        LawCertificate certificate;
        if (!end_closes(certificate.parts) || !bulk_closes(certificate.parts)) {
            return std::nullopt;
        }
        request.observer->enter("covering the layer", "boxes");
        auto layer = cover_layer(request.interrupted, *request.observer);
        if (!layer) {
            return std::nullopt;
        }
        request.observer->enter("proving the steps", "steps");
        auto steps = prove_steps(request.interrupted, *request.observer);
        if (!steps) {
            return std::nullopt;
        }
        certificate.layer = std::move(*layer);
        certificate.steps = std::move(*steps);
        return certificate;
    });
}

}  // namespace dumbbell::law
