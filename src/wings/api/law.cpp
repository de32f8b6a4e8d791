#include "dumbbell/law.hpp"

#include "api/exact_ratio.hpp"
#include "api/law_certificate.hpp"
#include "api/translate.hpp"
#include "file/sealed_lines.hpp"
#include "law/at_ratio.hpp"

namespace dumbbell::api {
inline namespace DUMBBELL_ABI {
namespace {

const std::vector<law::StepEnds>& proved_steps() {
    static const std::vector<law::StepEnds> steps = [] {
        const NamedFile text("the law's certificate", law_certificate());
        require(sealed_digest(text) == law::certificate_sha256,
                "the certificate in the library is not that of the law");
        return law::read_steps(text);
    }();
    return steps;
}

}  // namespace

Law law(const MassRatio& ratio) {
    return guarded([&]() -> Law {
        const auto at = dumbbell::law::law_at(single_ratio(ratio, "the law"), proved_steps());
        return {at.lower.str(), at.upper.str(), at.step.str(), {at.past.lo(), at.past.hi()}};
    });
}

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
