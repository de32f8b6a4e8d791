// What every fuzz target of this folder is: one function, called with an input by libFuzzer, or by the replay
// of the inputs that are kept here. It returns 0, or ends the program because something does not hold.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace dumbbell_fuzz {

/// Ends the program with a message, in every build.
[[noreturn]] inline void trap(const std::string& what) {
    std::fprintf(stderr, "fuzz: %s\n", what.c_str());
    __builtin_trap();
}

/// `what` must hold.
inline void must(bool holds, const char* what) {
    if (!holds) trap(std::string("not so: ") + what);
}

inline std::string text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

}  // namespace dumbbell_fuzz
