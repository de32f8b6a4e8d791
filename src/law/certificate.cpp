#include "law/certificate.hpp"

#include <fmt/core.h>

#include "base/printable.hpp"
#include "file/lines.hpp"
#include "file/unpacked_text.hpp"

namespace dumbbell::law {

std::string basis_text(const std::string& file, const std::string& sha256) {
    return fmt::format(
        "This rests on the law for every mass ratio (proofs/law.md) with its certificate\n"
        "{} (sha256 {}); dumbbell law checks it.\n",
        one_line(file), sha256);
}

std::vector<StepEnds> read_steps(const std::string& path) {
    Lines lines(path);
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

bool is_law_certificate(const std::string& path) {
    constexpr int before = 5;
    UnpackedText text(path);
    for (int i = 0; i < before; ++i) {
        (void)text.next_line();
    }
    return text.next_line() == "claim law\n";
}

}  // namespace dumbbell::law
