#pragma once

#include <string>

#include "base/observer.hpp"
#include "cli/options/given.hpp"

/// What `dumbbell plot` draws: from what is asked for to SVG text. Every certificate is verified first. All
/// throw InputError, saying what to run instead, for a certificate of another kind, one that is not verified,
/// or one that the picture cannot show.
namespace dumbbell::cli {

/// Each is told of what was given on the command line; the observer, of the phases after the first, which is
/// that a file is read.
[[nodiscard]] std::string draw_staircase(const Given& given, Observer& observer);
[[nodiscard]] std::string draw_orbit(const Given& given, Observer& observer);
[[nodiscard]] std::string draw_phase(const Given& given, Observer& observer);
[[nodiscard]] std::string draw_bodies(const Given& given, Observer& observer);

}  // namespace dumbbell::cli
