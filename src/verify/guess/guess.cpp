#include <algorithm>

#include "verify/guess/numbers.hpp"

namespace dumbbell_verify {

/// By the root of the parabola at z (third order); from the left it stays left of the root.
template <class N>
bool guess_root(const N& c, const N& kappa, N& z) {
    if constexpr (!std::is_same_v<N, double>) {  // most of the way in double
        double near = to_double(down, z);
        if (bits(c) > 64 && guess_root(to_double(down, c), to_double(down, kappa), near))
            z = bound(down, mpq_class(near), z);
    }
    for (int i = 0; i < 60; ++i) {
        const auto [s, w] = guess_sin_cos(z);
        const N gap = c + kappa * z - s, p = w - kappa, square = p * p - N(2) * gap * s;
        if (!(p > N(0)) && z > N(0)) {
            z = N(0);
            continue;
        }
        const N step = N(2) * gap / (p + guess_square_root(square));
        if (!(square >= N(0)) || !(z + step < N(2))) return false;
        z = z + step;
        if (std::max(step, -step) <= z * guess_tolerance(z)) return true;
    }
    return false;
}

/// By Newton's iteration.
template <class N>
N guess_top(const N& kappa, const N& quarter) {
    N z = guess_square_root(N(2) * (N(1) - kappa)), step = z;
    for (int i = 0; i < 60 && std::max(step, -step) > z * newton_tolerance(z); ++i) {
        const auto [s, w] = guess_sin_cos(z);
        step = (w - kappa) / s;
        z = z + step;
    }
    return std::min(z, quarter);
}

template bool guess_root(const double&, const double&, double&);
template bool guess_root(const Big&, const Big&, Big&);
template double guess_top(const double&, const double&);
template Big guess_top(const Big&, const Big&);

}  // namespace dumbbell_verify
