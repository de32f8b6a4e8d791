// A report that appears under its name complete or not at all.
#pragma once
#include <string>

namespace dumbbell_verify {

/// Throws std::invalid_argument if no file could be made there, or if what stands there is no regular file.
void require_replaceable(const std::string& path);

/// Writes a file beside it, makes it durable and gives it the name. Throws std::invalid_argument; then what
/// stood there before still stands there.
void replace_file(const std::string& path, const std::string& text);

}  // namespace dumbbell_verify
