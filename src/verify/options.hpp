// The command line of dumbbell-verify.
#pragma once
#include <string>
#include <vector>

#include "certificate.hpp"
#include "compare.hpp"

namespace dumbbell_verify {

struct Options {
    Settings settings;
    std::vector<std::string> files;
    bool json = false;
    const Lemma* lemma = nullptr;  ///< the two files are to be compared
    std::string answer;            ///< of --help and --version: print it, and nothing else
};

/// Throws std::invalid_argument with a message for the user.
Options parse_options(int argc, char** argv);

}  // namespace dumbbell_verify
