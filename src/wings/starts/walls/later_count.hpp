#pragma once

#include <algorithm>
#include <optional>

#include "flight/count.hpp"
#include "starts/air/flight.hpp"

/// Bounds of the number of later collisions of a box of states from the monotone count G (lemmas L5, L6),
/// without following them. Less is certain if interrupted.
namespace dumbbell::starts {

/// `most` is empty if nothing is certain.
struct LaterCount {
    long least = 0;
    std::optional<long> most = std::nullopt;

    [[nodiscard]] bool exact() const { return most == least; }
};

/// Counts beyond this are not looked at (nor by a verifier: format-initial.md, section 5).
inline constexpr long count_cap = 1'000'000;

/// G <= this for every ray with c >= 0 and kappa >= -r, for every ratio with 1/q >= r: the lowest such ray
/// meets the corner and returns with slope r and height r pi, so 1 + G(r pi, r, r) (L5). Nothing beyond the
/// cap.
template <class I>
[[nodiscard]] std::optional<long> most_later_collisions(const I& r, long cap = count_cap,
                                                        const Interrupted& interrupted = never) {
    const I lowest = low_end(r);
    const long later =
        as_long(count_at_most(flight::Ray<I>{low_end(lowest * pi<I>()), lowest, lowest}, cap, interrupted));
    return later > cap ? std::nullopt : std::optional(1 + later);
}

/// No regular trajectory has more collisions, for every ratio with 1/q >= r: two at q = 1 (L7), else 2 + k0 +
/// k1 (Theorem 1), and k1 <= k0 <= 1 + k1. It is the maximum at the greatest such q, unless that is so near
/// to a critical ratio that the arithmetic does not tell.
template <class I>
[[nodiscard]] std::optional<long> most_collisions(const I& r, long cap = count_cap,
                                                  const Interrupted& interrupted = never) {
    const I lowest = low_end(r);
    if (certainly_at_most(I(1), lowest)) {
        return 2;
    }
    const auto later = most_later_collisions(r, cap, interrupted);
    const long top = as_long(count_at_most(flight::Ray<I>{lowest, I(0), lowest}, cap, interrupted));
    return later && top <= cap ? std::optional(std::min(1 + 2 * *later, 2 + 2 * top)) : std::nullopt;
}

namespace detail {

/// G over the rays (c, kappa) of a box, kappa >= -r certain.
template <class I>
LaterCount ray_counts(const I& c, const I& kappa, const I& r, const Interrupted& interrupted) {
    const I height = max(I(0), c);
    const long most = as_long(count_at_most(flight::Ray<I>{height, kappa, r}, count_cap, interrupted));
    return {as_long(count_at_least(flight::Ray<I>{height, kappa, r}, count_cap, interrupted)),
            most > count_cap ? std::nullopt : std::optional(most)};
}

}  // namespace detail

/// The later collisions of states that leave a contact of `left` in this way.
///
/// From the bridge, and from a light wall if the bridge is certainly passed, they are G (L4, L6 (b), (c)). If
/// the bridge may be met: those that pass it have c >= 0, those that meet it at most 1 + G from there.
template <class S>
[[nodiscard]] LaterCount later_collisions(const Outbound<S>& d, const S& ratio, flight::End left,
                                          const Interrupted& interrupted = never) {
    using I = Enclosure<S>;
    const I& r = range(ratio);
    if (!certainly_at_most(-low_end(r), range(d.slope))) {
        return {0,
                left == flight::End::heavy ? most_later_collisions(r, count_cap, interrupted) : std::nullopt};
    }
    if (left == flight::End::heavy) {
        return detail::ray_counts(range(d.height), range(d.slope), r, interrupted);
    }
    LaterCount passing =
        detail::ray_counts(range(d.height + d.slope * S(pi<I>())), range(d.slope), r, interrupted);
    if (certainly_passes_bridge(d, ratio)) {
        return passing;
    }
    const auto behind = most_later_collisions(r, count_cap, interrupted);
    passing.least = 0;
    passing.most =
        passing.most && behind ? std::optional(std::max(*passing.most, 1 + *behind)) : std::nullopt;
    return passing;
}

}  // namespace dumbbell::starts
