#pragma once

#include <string>

#include "collisions/writer.hpp"
#include "file/sha256.hpp"

namespace dumbbell_test {

/// A text with a change, and its checksum made right again.
inline std::string resealed(std::string text, const std::string& from, const std::string& to) {
    text.erase(text.rfind("sha256 "));
    text.replace(text.find(from), from.size(), to);
    return text + "sha256 " + dumbbell::sha256_hex(text) + "\n";
}

}  // namespace dumbbell_test
