#include "campaign/worker_commands.hpp"

#include <fmt/core.h>

#include "base/printable.hpp"

namespace dumbbell::campaign {
namespace {

/// `port` is a number, or an expression of the shell that it is for.
std::string worker(const std::string& password_file, const std::string& cores, const std::string& host,
                   const std::string& port) {
    return fmt::format("work_queue_worker --password {} --cores {} {} {}", shell_quoted(password_file), cores,
                       shell_quoted(host), port);
}

bool is_loopback(const std::string& address) { return address.starts_with("127.") || address == "::1"; }

/// Does it listen on all addresses of the machine?
bool is_anywhere(const std::string& address) { return address == "0.0.0.0" || address == "::"; }

/// An address that reaches a manager on this machine.
std::string here(const ManagerPlace& manager) {
    return !is_anywhere(manager.address) ? manager.address : manager.address == "::" ? "::1" : "127.0.0.1";
}

}  // namespace

std::string reached_as(const ManagerPlace& manager, const std::string& host) {
    return is_anywhere(manager.address) ? host : manager.address;
}

std::string worker_command(const ManagerPlace& manager, const std::string& host) {
    return worker(manager.password_file, "0", host, std::to_string(manager.port));
}

std::string worker_examples(const ManagerPlace& manager, const std::string& host) {
    const std::string port = std::to_string(manager.port);
    const std::string local = here(manager);
    const std::string end_of_tunnel = local.find(':') == std::string::npos ? local : "[" + local + "]";
    const std::string copied = "dumbbell-password";
    std::string text = fmt::format("# on this machine\n{}\n", worker_command(manager, local));

    text += fmt::format(
        "# on OTHER, from here: a tunnel for as long as the worker runs, which also keeps the wire secret\n"
        "scp -p {} OTHER:{}\n"
        "ssh -o ExitOnForwardFailure=yes -R {}:{}:{} OTHER {}\n",
        shell_quoted(manager.password_file), copied, port, end_of_tunnel, port,
        worker(copied, "0", "127.0.0.1", port));

    if (is_loopback(manager.address)) {
        text += fmt::format(
            "# Slurm: 16 workers of 4 cores, each with a tunnel to here, in a home folder shared with here\n"
            "sbatch --array=1-16 --cpus-per-task=4 --wrap {}\n",
            shell_quoted(
                fmt::format("port=$((20000 + SLURM_ARRAY_TASK_ID)); ssh -f -N -o ExitOnForwardFailure=yes "
                            "-L $port:{}:{} {} && {}",
                            end_of_tunnel, port, shell_quoted(host),
                            worker(manager.password_file, "4", "127.0.0.1", "$port"))));
    } else {
        text += fmt::format(
            "# Slurm: 16 workers of 4 cores, in a home folder shared with here\n"
            "sbatch --array=1-16 --cpus-per-task=4 --wrap {}\n",
            shell_quoted(worker(manager.password_file, "4", host, port)));
    }
    return text;
}

}  // namespace dumbbell::campaign
