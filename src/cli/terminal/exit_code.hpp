#pragma once

namespace dumbbell::cli {

/// The exit codes of `dumbbell` (`dumbbell-verify` has its own).
enum ExitCode : int {
    exit_done = 0,           ///< done as asked
    exit_internal = 1,       ///< internal error, or the arithmetic's self-test failed
    exit_bad_input = 2,      ///< wrong usage or input
    exit_not_certified = 3,  ///< not everything was certified (within the budget)
    exit_stopped = 128,      ///< plus the number of the signal: 130 for SIGINT, 143 for SIGTERM
};

}  // namespace dumbbell::cli
