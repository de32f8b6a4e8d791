#pragma once

#include <array>

/// The two covers that need no bisection: equal parts of a range.
namespace dumbbell::law {

/// The parts of th in [0, 0.6], [0.6, 0.7] and [0.7, 0.7944], and those of d in [0, 0.09].
struct Parts {
    std::array<int, 3> bulk{6000, 1000, 2000};
    int end = 1500;
};

/// Whether on every part D and J - J' lie within the bounds of its range: (C9), (C10) of proofs/law.md.
[[nodiscard]] bool bulk_closes(const Parts& parts);

/// Whether every part is certainly beyond eps = 1/1000, or e_end within its bounds (C11).
[[nodiscard]] bool end_closes(const Parts& parts);

}  // namespace dumbbell::law
