#pragma once

#include <CLI/App.hpp>
#include <string>

namespace dumbbell {

/// Adds --out FILE to a command, for `file`, which outlives it; an empty name is refused.
CLI::Option* add_out_option(CLI::App& command, std::string& file,
                            const char* text = "write the certificate to FILE (FILE.gz: compressed)");

}  // namespace dumbbell
