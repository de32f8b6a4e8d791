#pragma once

#include "cli/commands/join_parts.hpp"

namespace dumbbell::cli {

/// Why the files, in the order of their ranges, are not this whole: a line for each that is wrong or too
/// much, and for what is missing, with the command that makes it. Throws InputError if they are parts of
/// several claims.
[[nodiscard]] std::vector<std::string> faults_of(const Parts& parts, const std::vector<PartFile>& files,
                                                 const collisions::Range& whole);

/// A line about a part, with the command that makes it again, if that is known.
[[nodiscard]] std::string with_command(const Parts& parts, const PartFile& file, const std::string& line);

}  // namespace dumbbell::cli
