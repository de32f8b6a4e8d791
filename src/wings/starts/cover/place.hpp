#pragma once

#include <array>
#include <cstdint>

#include "starts/cover/certificate.hpp"

namespace dumbbell::starts {

/// A box of a bisection tree: how often each axis was halved, and which part of it this is.
struct Place {
    std::array<std::uint64_t, axis_count> part{};
    std::array<std::uint8_t, axis_count> depths{};

    [[nodiscard]] Box in(const Box& root) const {
        Box box = root;
        for (std::size_t i = 0; i < axis_count; ++i) {
            if (depths[i] > 0) {
                Rational width = root.hi[i] - root.lo[i];
                mpq_div_2exp(width.raw(), width.raw(), depths[i]);
                box.lo[i] += width * Rational(part[i]);
                box.hi[i] = box.lo[i] + width;
            }
        }
        return box;
    }

    [[nodiscard]] Place half(Axis axis, bool upper) const {
        const auto i = static_cast<std::size_t>(axis);
        Place result = *this;
        result.part[i] = 2 * part[i] + (upper ? 1 : 0);
        ++result.depths[i];
        return result;
    }
};

}  // namespace dumbbell::starts
