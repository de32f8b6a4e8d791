#include "law/certificate.hpp"

#include "file/lines.hpp"

namespace dumbbell::law {

std::vector<StepEnds> read_steps(const NamedFile& source) {
    Lines lines(source);
    std::vector<StepEnds> steps;
    for (long n = first_step; n <= last_step;) {
        const auto& fields = lines.next();
        if (fields[0] != "step") {
            continue;
        }
        if (fields.size() != 4 || lines.number(fields[1]) != n++) {
            lines.fail();
        }
        steps.push_back({lines.ratio(fields[2]), lines.ratio(fields[3])});
    }
    return steps;
}

}  // namespace dumbbell::law
