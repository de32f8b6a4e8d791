#pragma once

#include <string>
#include <vector>

#include "cli/options/given.hpp"

namespace dumbbell::cli {

struct CommandLine {
    const Command* command = nullptr;
    Given given;         ///< with the options of the commands above
    std::string answer;  ///< of --help and --version: print it, and nothing else
};

/// `words`: those after the program's name. Throws InputError, which says what is wrong and where to read
/// on.
[[nodiscard]] CommandLine parse(const Command& program, const std::string& version,
                                const std::vector<std::string>& words);

}  // namespace dumbbell::cli
