#pragma once

#include "cli/options/option.hpp"

/// The commands, each in a file of its own; some are of wings, in src/wings/commands.
namespace dumbbell::cli {

extern const Command certify_command, critical_command, join_command, trace_command, adiabatic_command,
    verify_command, audit_command, law_command, plot_command, report_command;
/// For the makers of packages: the man page and the reference, from the whole table.
/// No help shows it.
extern const Command generate_command;

/// The program itself, with all of them.
extern const Command dumbbell_command;

}  // namespace dumbbell::cli
