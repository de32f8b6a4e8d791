#pragma once

#include <string_view>

#include "base/named.hpp"
#include "collisions/certificate.hpp"

/// The words of the file format (format.md) for leaves and witnesses, and those of reports. Each is a switch
/// without default (base/named.hpp).
namespace dumbbell::collisions {

/// The word of a leaf, which is also its kind in the totals.
[[nodiscard]] constexpr std::string_view name(Reason reason) {
    switch (reason) {
        case Reason::count:
            return "count";
        case Reason::outside:
            return "outside";
        case Reason::meets:
            return "meets";
        case Reason::meets_reversed:
            return "meets-reversed";
        case Reason::once:
            return "once";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view name(Place place) {
    switch (place) {
        case Place::bridge:
            return "bridge";
        case Place::corner:
            return "corner";
    }
    return {};
}

/// What a piece proves, as reports say it.
[[nodiscard]] constexpr std::string_view name(Status status) {
    switch (status) {
        case Status::exact:
            return "exact";
        case Status::gap:
            return "gap";
        case Status::open:
            return "open";
    }
    return {};
}

/// The cover of one line of equal masses (L7), of symmetric bodies (L72), and by orbits (L87).
inline constexpr std::string_view equal_masses_word = "equal-masses", symmetric_word = "symmetric",
                                  orbits_word = "orbits";

}  // namespace dumbbell::collisions
