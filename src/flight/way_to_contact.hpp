#pragma once

namespace dumbbell::flight {

/// For doubles and packs of them: from a point with this sine and cosine to the contact, an error of fourth
/// order. `newton` is Newton's step, `inverse` 1/slope. A guess.
template <class D, class At>
[[nodiscard]] D way_to_contact(D newton, D inverse, const At& at) {
    const D bend = (0.5 * at.sin) * inverse;
    const D twist = (at.cos * inverse) * (1.0 / 6);
    const D curved = newton + newton * (bend * newton);
    return newton + (curved * curved) * (bend + twist * curved);
}

}  // namespace dumbbell::flight
