#pragma once

#include <string>
#include <vector>

#include "base/observer.hpp"

/// What `dumbbell plot` draws: from what is asked for to SVG text. Every certificate is verified first. All
/// throw InputError, saying what to run instead, for a certificate of another kind, one that is not verified,
/// or one that the picture cannot show.
namespace dumbbell::cli {

struct PlotRequest {
    std::string file;   ///< of an orbit possibly a mass ratio
    std::string ratio;  ///< which one to draw, of a certificate over a range; empty: it has only one
    Observer* observer = &nobody;  ///< told of the phases after the first, which is that a file is read
};

[[nodiscard]] std::string draw_staircase(const PlotRequest& request);
[[nodiscard]] std::string draw_orbit(const PlotRequest& request);
[[nodiscard]] std::string draw_phase(const PlotRequest& request);
[[nodiscard]] std::string draw_bodies(const std::vector<std::string>& files, Observer& observer);

}  // namespace dumbbell::cli
