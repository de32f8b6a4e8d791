// The certificates of this project, for tests.
#pragma once
#include <fstream>
#include <sstream>
#include <string>

namespace make {

inline std::string shipped(const std::string& name) { return DUMBBELL_PROJECT "/certificates/" + name; }
inline std::string contents(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

}  // namespace make
