// The command line of dumbbell-verify.
#pragma once
#include <string>
#include <vector>

#include "verify/program/examine.hpp"

namespace dumbbell_verify {

struct Options {
    std::vector<Job> jobs;  ///< the files, each with its settings and its share of the threads
    unsigned at_once = 1;   ///< the number of files that are checked at the same time
    bool json = false;
    bool leaves = false;  ///< of one file: what its lines cover
    bool quiet = false;   ///< only the last line of what would be printed
    std::string answer;   ///< of --help and --version: print it, and nothing else
};

/// Throws std::invalid_argument with a message for the user.
Options parse_options(const std::vector<std::string>& words);

}  // namespace dumbbell_verify
