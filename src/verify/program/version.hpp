// Which verifier this is.
#pragma once
#include <string_view>

#ifndef DUMBBELL_VERSION
#define DUMBBELL_VERSION "0.0.0"
#endif

namespace dumbbell_verify {

inline constexpr std::string_view version = DUMBBELL_VERSION;

}  // namespace dumbbell_verify
