// The certificates of this project, for tests.
#pragma once
#include "temporary_folder.hpp"

namespace make {

inline std::string shipped(const std::string& name) { return DUMBBELL_PROJECT "/certificates/" + name; }
using dumbbell_test::contents;

}  // namespace make
