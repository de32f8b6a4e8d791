#pragma once

#include "number/interval.hpp"

/// One step of an orbit in the bulk, U >= 9/10 (proofs/law.md, L51).
namespace dumbbell::law {

struct BulkBounds {
    Interval defect;  ///< M: D = (eps/2) M (alpha' - alpha)
    Interval fall;    ///< (J - J')/(eps^2 (alpha' - alpha))
};

/// P(Q, th) of L46 for th in this interval, in [0, 0.7944], and Q in pi/2 + [-1, 3]/100000.
[[nodiscard]] Interval P_at(const Interval& th);

/// Of the steps with th in this interval, eps in this one, in [0, 1/1000], Q as above, and with P_at(th).
[[nodiscard]] BulkBounds bulk_bounds(const Interval& th, const Interval& eps, const Interval& P);

}  // namespace dumbbell::law
