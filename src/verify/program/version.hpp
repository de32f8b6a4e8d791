// Which verifier this is, and how it was made.
#pragma once
#include <string_view>

namespace dumbbell_verify {

inline constexpr std::string_view version =
#ifdef DUMBBELL_FLAGS
    DUMBBELL_VERSION " (" DUMBBELL_COMPILER ", " DUMBBELL_BUILD_TYPE ", licence: MIT, flags: " DUMBBELL_FLAGS
                     ")";
#else
    "0.0.0 (" __VERSION__ ")";
#endif

}  // namespace dumbbell_verify
