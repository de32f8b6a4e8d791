#pragma once

#include <fstream>
#include <iterator>
#include <string>

namespace dumbbell {

/// All bytes of a file; none if it cannot be read.
[[nodiscard]] inline std::string file_contents(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace dumbbell
