#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <vector>

#include "base/observer.hpp"
#include "collisions/critical.hpp"
#include "staircase/critical_confirm.hpp"

namespace dumbbell::staircase {

struct CriticalRequest {
    long first = 3;  ///< q_c(first), ..., q_c(last); 3 <= first <= last
    long last = 3;
    int digits = 15;
    std::optional<Rational> confirm;  ///< check by covers and witnesses at this relative distance, too
    int jobs = 1;
    std::optional<std::chrono::duration<double>> budget;
    Observer* observer = &nobody;  ///< told of the ratios that are finished; of a single one, of its flights
};

struct CriticalRow {
    long n = 0;
    std::optional<collisions::CriticalRatio> ratio;  ///< nothing: not within the budget
    std::optional<Confirmation> confirmation;

    [[nodiscard]] bool finished(const CriticalRequest& request) const {
        return ratio && (!request.confirm || (confirmation && confirmation->holds()));
    }
};

/// One row per n, in order; the rows do not depend on the number of jobs. Throws BrokenInvariant if the
/// arithmetic of a thread is not sound.
[[nodiscard]] std::vector<CriticalRow> critical_ratios(const CriticalRequest& request);

/// About how long the enclosures will take (without confirmation), from the processor time that a small one
/// takes here: on a machine that does nothing else.
[[nodiscard]] std::chrono::duration<double> estimated_time(const CriticalRequest& request);

/// The share of that time which the first so many ratios take, from 0 to 1: orbits get longer.
[[nodiscard]] double share_of_first(std::size_t ratios, const CriticalRequest& request);

}  // namespace dumbbell::staircase
