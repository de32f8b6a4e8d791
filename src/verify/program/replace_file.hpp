// A report that appears under its name complete or not at all.
#pragma once
#include <string>
#include <vector>

namespace dumbbell_verify {

/// Throws std::invalid_argument if no file could be made there, if what stands there is no regular file, or
/// is one of the inputs, also through links, or if it lies below /dev (but /dev/shm) or /proc.
void require_replaceable(const std::string& path, const std::vector<std::string>& inputs);

/// Writes a file next to it, makes it durable and gives it the name, and the access rights of what stood
/// there. Of a link its end is replaced. Throws std::invalid_argument; then what stood there before still
/// stands there.
void replace_file(const std::string& path, const std::string& text);

}  // namespace dumbbell_verify
