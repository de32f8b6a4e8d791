// The section plain (format-sections.md, section 2; L16). A file spells it `lemmas minimal`, `section full`.
#include "verify/core/big.hpp"
#include "verify/sections/flights.hpp"

namespace dumbbell_verify {
namespace {

template <class N>
class Plain : Flights<N> {
    using Base = Flights<N>;
    using Base::fact, Base::leaf_;

  public:
    Plain(const Leaf& leaf, Log* log) : Base(leaf, plain(), log) {}

    const char* verdict() {
        if (!(Base::r_lo > Base::zero)) return "r is out of the range of this precision";
        if (leaf_.opcode == outside)
            return Base::is_outside(leaf_.chart != departure) ? nullptr : "a reason of `outside`";
        if (leaf_.opcode == once_leaf) return Base::once() ? nullptr : Base::failed();
        return Base::counts() ? nullptr : Base::failed();
    }
};

const char* check_plain(const Leaf& leaf, Log* log) {
    if (leaf.opcode == equal_masses || leaf.opcode == witness) return turning().check(leaf, log);
    return judged<Plain>(leaf, log);
}

}  // namespace

const Section& plain() {
    static const Section section = full_section("minimal", check_plain);
    return section;
}

}  // namespace dumbbell_verify
