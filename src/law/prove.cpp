#include "law/prove.hpp"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "law/steps.hpp"
#include "number/self_test.hpp"

namespace dumbbell::law {

std::optional<LawCertificate> prove_law(const LawRequest& request) {
    require_sound_arithmetic();
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(request.jobs));
    tbb::task_arena arena(request.jobs);
    return arena.execute([&]() -> std::optional<LawCertificate> {
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
