#pragma once

#include <string>

namespace dumbbell::cli {

/// The file that the name of an input stands for: `-` is the standard input, read to its end here, so that
/// `/dev/stdin` can be read again and again, by the verifier that this program starts, too. Throws InputError
/// if it cannot be read.
[[nodiscard]] std::string input_file(const std::string& name);

/// A message about files as the user named them: '-' in the place of '/dev/stdin', if that was one of them.
[[nodiscard]] std::string as_named(std::string message);

}  // namespace dumbbell::cli
