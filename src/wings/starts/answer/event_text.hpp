#pragma once

#include <optional>
#include <string>

#include "starts/air/exact_event.hpp"
#include "starts/cover/subdivide.hpp"
#include "words/json.hpp"

/// How corners, flat falls and grazing contacts are said.
namespace dumbbell::starts {

/// What a start, or a part of a box, is on or near to: `a grazing contact`; empty for `other`.
[[nodiscard]] std::string event_text(Obstacle obstacle);

/// The kinds of undecided boxes and their numbers, in a line; empty if there are none.
[[nodiscard]] std::string kinds_text(const Subdivision& parts);
[[nodiscard]] Json kinds_json(const Subdivision& parts);

/// What exact arithmetic says of an orbit that ends in a corner.
[[nodiscard]] std::string corner_text(const ExactEvent& event);

/// An event after `collisions` collisions: one that is certain, or what is not excluded. Precondition: there
/// is one of them.
[[nodiscard]] Json event_json(const std::optional<ExactEvent>& event, const std::optional<Obstacle>& obstacle,
                              std::size_t collisions);

}  // namespace dumbbell::starts
