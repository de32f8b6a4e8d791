#pragma once

namespace dumbbell {

/// Checks on the calling thread what every enclosure rests on: rounding to nearest, gradual underflow, and a
/// hard addition, multiplication, division and square root whose correctly rounded results are known.
///
/// Throws BrokenInvariant where the environment fails (another rounding mode, flush-to-zero, fused or
/// extended evaluation). Cheap (a few dozen operations): called at start-up and by every worker thread before
/// it computes.
void require_sound_arithmetic();

}  // namespace dumbbell
