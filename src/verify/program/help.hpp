// What `dumbbell-verify --help` prints, and its manual page.
#pragma once
#include <string>

namespace dumbbell_verify {

std::string help();
std::string man_page();

}  // namespace dumbbell_verify
