#pragma once

#include <optional>
#include <string>

#include "starts/cover/certificate.hpp"
#include "starts/given/angle.hpp"

namespace dumbbell::starts {

/// The quantities of a start as a user writes them: each a number or LO:HI, phi an angle or LO:HI.
struct StartText {
    std::string phi, phidot, y, ydot;
};

/// What is meant by a start, as far as its box does not say it: multiples of pi are
/// irrational, and the box has rational bounds of them.
struct StartMeaning {
    bool is_single = false;      ///< one initial condition
    std::optional<Angle> phi{};  ///< exactly, if it is one angle of this form
    std::string rounded_phi{};   ///< how phi was given, if the box has bounds of it; else empty
};

struct GivenStart {
    Box box;  ///< holds every initial condition that is meant
    StartMeaning meaning;
};

/// Bits for bounds that are as good as exact when `digits` digits are computed (0: doubles).
[[nodiscard]] int bits_of_bounds(int digits);

/// Reads it. `dashes`: what stands before the names of quantities in messages. `bits`: of the bounds of an
/// irrational angle. `rho`: of a body, whose Q is the ratio. Throws InputError for what cannot be read, and
/// what require_in_play refuses.
[[nodiscard]] GivenStart read_start(const StartText& text, const Rational& q_lo, const Rational& q_hi,
                                    const std::string& dashes, int bits,
                                    const std::optional<Rational>& rho = std::nullopt);

}  // namespace dumbbell::starts
