// `--lemma`: two verified files compared ratio by ratio (format-sections.md, section 4).
#pragma once
#include <string>
#include <string_view>

#include "verify/format/claim.hpp"

namespace dumbbell_verify {

/// upper of A <= lower of B + slack, A and B of these scenes.
struct Lemma {
    std::string_view name, scene_a, scene_b;
    std::uint64_t slack;
};
const Lemma* find_lemma(std::string_view name);  ///< nullptr if there is none of this name

struct Comparison {
    bool holds;
    std::string text;  ///< after the verdict
    std::string
        json;  ///< the same as an object: ratio, excess, least_excess, gaps; null what there is not; reason
};
/// Both claims kept their parts. Compares on the common range, or on the part of it that was demanded.
Comparison compare(const Lemma& lemma, const Collisions& a, const Collisions& b);

}  // namespace dumbbell_verify
