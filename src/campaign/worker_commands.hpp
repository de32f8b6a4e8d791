#pragma once

#include <string>

namespace dumbbell::campaign {

/// Where a manager waits for its workers.
struct ManagerPlace {
    std::string address;        ///< numeric, that it listens on
    int port = 0;               ///< that it listens on
    std::string password_file;  ///< on this machine
};

/// How others reach it: its address, or if it listens on all of this machine, that one's name, `host`.
[[nodiscard]] std::string reached_as(const ManagerPlace& manager, const std::string& host);

/// The one line that starts a worker, on all cores of the machine that it is typed on, for a manager that is
/// reached as `host`. For a shell.
[[nodiscard]] std::string worker_command(const ManagerPlace& manager, const std::string& host);

/// Lines to copy from, with remarks: a worker on this machine, on another one through ssh, and a Slurm array.
/// `host` is the name of this machine for the others; they go through tunnels while the manager listens on
/// the loopback address.
[[nodiscard]] std::string worker_examples(const ManagerPlace& manager, const std::string& host);

}  // namespace dumbbell::campaign
