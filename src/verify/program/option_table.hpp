// The options of dumbbell-verify, the one place where they are: the command line is read by this table, and
// --help is made from it.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "verify/program/arguments.hpp"
#include "verify/program/claim_options.hpp"
#include "verify/program/options.hpp"

namespace dumbbell_verify {

/// What the command line has asked for so far.
struct Asked {
    Options options;   ///< its jobs are the files, without their settings
    Request settings;  ///< of each file
    ClaimWords claim;  ///< what its options say
    std::string claims;
};

inline void read_claim(Arguments& given, Asked& to) { claim_option(given, to.claim); }

struct Option {
    std::string_view name;                                   ///< --out, or `-h, --help`
    std::string_view value;                                  ///< the name of its value; empty: it has none
    std::string_view text;                                   ///< what it means
    void (*read)(Arguments& given, Asked& to) = read_claim;  ///< throws std::invalid_argument
    std::string_view excludes{};  ///< options that cannot be given with it, with spaces between
};

std::span<const Option> option_table();

}  // namespace dumbbell_verify
