// The precision of a leaf: double first, because what it certifies is certified, and most leaves need no
// more.
#pragma once
#include <string>

#include "verify/number/big.hpp"

namespace dumbbell_verify {

/// nullptr if Judge certifies the leaf in double, or else with the leaf's bits; otherwise what is missing. A
/// leaf that is `multiple` is not tried in double. Judge needs a name that no other judge of this leaf type
/// has: g++ merges the instances of equally named templates, though they are in unnamed namespaces.
template <template <class> class Judge, class AnyLeaf>
const char* judged(const AnyLeaf& leaf, std::string* log) {
    if (!leaf.multiple) {
        const char* missing = Judge<double>(leaf, log).verdict();
        if (!missing || leaf.bits == 53) return missing;
    }
    Big::precision = leaf.bits;
    return Judge<Big>(leaf, log).verdict();
}

}  // namespace dumbbell_verify
