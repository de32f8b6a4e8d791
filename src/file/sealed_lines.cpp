#include "file/sealed_lines.hpp"

#include "file/lines.hpp"

namespace dumbbell {

void SealedLines::head(const Generator& generator, std::string_view lemmas, std::string_view scene,
                       std::string_view section, std::string_view claim) {
    line("dumbbell-certificate 1");
    line("generator {} {}", generator.program, generator.version);
    line("lemmas {}", lemmas);
    line("scene {}", scene);
    line("section {}", section);
    line("claim {}", claim);
}

}  // namespace dumbbell
