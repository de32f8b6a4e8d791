// What `dumbbell-verify --help` prints.
#pragma once
#include <string>

namespace dumbbell_verify {

std::string help();

}  // namespace dumbbell_verify
