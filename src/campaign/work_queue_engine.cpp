#include "campaign/work_queue_engine.hpp"

#include <fmt/core.h>
#include <nettle/base64.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/deadline.hpp"
#include "base/error.hpp"
#include "base/printable.hpp"
#include "campaign/password.hpp"
#include "campaign/work_queue_api.hpp"
#include "file/last_line.hpp"

namespace dumbbell::campaign {
namespace {

constexpr std::string_view plain_characters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._-";
constexpr std::size_t failures_that_count = 3;
constexpr std::size_t longest_reason = 200;
constexpr std::size_t longest_host_name = 100;
constexpr int end_too_long = 3;      // of `dumbbell campaign work`
constexpr int end_of_timeout = 124;  // of timeout(1)

/// Bytes of base64 without line breaks; nothing for any other text.
std::optional<std::string> from_base64(std::string_view text) {
    std::string bytes(BASE64_DECODE_LENGTH(text.size()), '\0');
    std::size_t size = 0;
    base64_decode_ctx context{};
    base64_decode_init(&context);
    const bool decodes = base64_decode_update(&context, &size, reinterpret_cast<std::uint8_t*>(bytes.data()),
                                              text.size(), text.data()) == 1 &&
                         base64_decode_final(&context) == 1;
    if (!decodes || text.size() != (size + 2) / 3 * 4) {  // the decoder passes over white space
        return {};
    }
    bytes.resize(size);
    return bytes;
}

std::string checked_program(const std::string& program) {
    if (!program.starts_with('/') ||
        program.find_first_not_of(std::string(plain_characters) + "/") != std::string::npos) {
        throw InputError(
            fmt::format("'{}' cannot be the program on the workers: give an absolute path of letters, "
                        "digits and ._/- such as /usr/bin/dumbbell",
                        printable(program, longest_reason)));
    }
    return program;
}

double seconds(timestamp_t microseconds) { return static_cast<double>(microseconds) * 1e-6; }

std::size_t count(int number) { return static_cast<std::size_t>(std::max(number, 0)); }

/// Why the library gives a task back without the end of its command; in its own words where they say enough.
std::string why(const work_queue_task& task) {
    if (task.result == WORK_QUEUE_RESULT_MAX_RETRIES) {
        return fmt::format("given up after {} tries: each time its worker was lost",
                           WorkQueueEngine::most_tries);
    }
    return fmt::format("the worker reports {}", work_queue_result_str(task.result));
}

}  // namespace

WorkQueueEngine::PrivateFolder::PrivateFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "dumbbell-campaign-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
        throw InputError(fmt::format(
            "cannot make the temporary folder '{}': {}; set TMPDIR to a folder that can be written to", name,
            std::strerror(errno)));
    }
    path_ = name;
}

WorkQueueEngine::PrivateFolder::~PrivateFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

WorkQueueEngine::WorkQueueEngine(WorkQueueOptions options) : options_(std::move(options)) {
    const std::string password = read_password(options_.password_file);
    if (options_.program.empty()) {
        // A copy: the original may be replaced by another version while the campaign runs.
        copy_.emplace();
        std::error_code error;
        if (!std::filesystem::copy_file("/proc/self/exe", copy_->path() / "dumbbell", error)) {
            throw InputError(fmt::format("cannot copy this program to '{}', to send it to the workers: {}",
                                         copy_->path().string(), error.message()));
        }
    } else {
        options_.program = checked_program(options_.program);
    }
    queue_ = make_work_queue_manager(options_.address, options_.port, password);
    options_.port = work_queue_port(queue_.get());
    work_queue_specify_keepalive_interval(queue_.get(), static_cast<int>(options_.ask_after.count()));
    work_queue_specify_keepalive_timeout(queue_.get(), static_cast<int>(options_.answer_within.count()));
}

WorkQueueEngine::~WorkQueueEngine() {
    for (const auto& [id, task] : under_way_) {
        work_queue_cancel_by_taskid(queue_.get(), id);
        work_queue_task_delete(task);
    }
}

/// A worker gives this to sh, so that it holds nothing from outside but what is checked here. Only base64
/// leaves on the good end, and the last of the program's messages on any other.
///
/// A worker ends a task by its process group, which it makes after it has started the task, and on a busy
/// machine too late: then it waits for the task's own end. So the task makes the group itself, by timeout(1)
/// without a time.
std::string WorkQueueEngine::command(const Task& task) const {
    std::string limit;
    std::string guard;
    if (task.limit) {
        require(std::isfinite(task.limit->count()) && task.limit->count() > 0, "a limit that is no time");
        limit = fmt::format(" --limit {:.3f}", std::max(task.limit->count(), 0.001));
        // Not the library's own limit: manager and worker do not agree on its unit, and a worker of several
        // cores ends whatever takes a second. In the foreground, or it would not be in the task's group.
        const double seconds = 2 * task.limit->count() + static_cast<double>(options_.overtime.count());
        guard = fmt::format("timeout --foreground -k 60 {:.0f} ", std::ceil(std::min(seconds, 1e9)));
    }
    return fmt::format(
        "exec timeout 0 sh -c '"
        "{0}{1} campaign work{2} order result > log 2>&1; end=$?; "
        "if test $end -ne 0; then tail -c 1000 log 2> /dev/null; "
        "case $end in {3}|{4}) exit {3};; esac; exit 1; fi; "
        "if test -L result || test ! -f result; then echo no result; exit 1; fi; "
        "if test $(wc -c < result) -gt {5}; then echo a result of more than {5} bytes; exit 1; fi; "
        "base64 -w 0 result'",
        guard, copy_ ? "./dumbbell" : options_.program, limit, end_too_long, end_of_timeout,
        options_.largest_result);
}

void WorkQueueEngine::submit(const Task& task) {
    work_queue_task* made = work_queue_task_create(command(task).c_str());
    work_queue_task_specify_tag(made, task.id.c_str());
    work_queue_task_specify_cores(made, 1);
    work_queue_task_specify_max_retries(made, most_tries);
    work_queue_task_specify_buffer(made, task.order.data(), static_cast<int>(task.order.size()), "order",
                                   WORK_QUEUE_NOCACHE);
    if (copy_) {
        work_queue_task_specify_file(made, (copy_->path() / "dumbbell").c_str(), "dumbbell", WORK_QUEUE_INPUT,
                                     WORK_QUEUE_CACHE);
    }
    for (const std::filesystem::path input : task.inputs) {
        const std::string name = input.filename().string();
        require(!name.empty() && name.find_first_not_of(plain_characters) == std::string::npos &&
                    name != "." && name != ".." && name != "order" && name != "result" && name != "log" &&
                    name != "dumbbell",
                "an input of a task with a name that it cannot have on a worker");
        work_queue_task_specify_file(made, input.c_str(), name.c_str(), WORK_QUEUE_INPUT, WORK_QUEUE_CACHE);
    }
    under_way_.emplace(work_queue_submit(queue_.get(), made), made);
}

std::optional<Outcome> WorkQueueEngine::wait(std::chrono::milliseconds time) {
    const auto end = std::chrono::steady_clock::now() + time;
    do {
        if (stop_signal != 0) {
            return {};
        }
        if (work_queue_task* task = work_queue_wait(queue_.get(), 1)) {
            Outcome outcome = outcome_of(*task);
            if (task->hostname != nullptr) {
                count_failures(task->hostname, outcome);
            }
            resent_ += count(task->try_count - 1);
            under_way_.erase(task->taskid);
            work_queue_task_delete(task);
            return outcome;
        }
    } while (std::chrono::steady_clock::now() < end);
    return {};
}

Outcome WorkQueueEngine::outcome_of(const work_queue_task& task) const {
    Outcome outcome;
    outcome.id = task.tag;
    outcome.worker = printable(task.hostname != nullptr ? task.hostname : "", longest_host_name);
    outcome.seconds = seconds(task.time_workers_execute_last);
    const std::string_view output = task.output != nullptr ? task.output : "";
    if (task.result == WORK_QUEUE_RESULT_SUCCESS && task.return_status == end_too_long) {
        outcome.end = Outcome::End::too_long;
    } else if (task.result != WORK_QUEUE_RESULT_SUCCESS) {
        outcome.reason = why(task);
    } else if (task.return_status != 0) {
        const std::string_view said = last_line(output);
        outcome.reason =
            said.empty() ? "no result, and no message: is its disk full?" : printable(said, longest_reason);
    } else if (output.size() > (options_.largest_result + 2) / 3 * 4) {
        outcome.reason = fmt::format("a result of more than {} bytes", options_.largest_result);
    } else if (auto bytes = from_base64(output)) {
        outcome.end = Outcome::End::done;
        outcome.result = std::move(*bytes);
    } else {
        outcome.reason = "garbage instead of a result";
    }
    return outcome;
}

/// Different tasks: one that fails everywhere says nothing about a host.
void WorkQueueEngine::count_failures(const std::string& host, Outcome& outcome) {
    if (outcome.end != Outcome::End::failed) {
        failed_in_a_row_.erase(host);
        return;
    }
    auto& failed = failed_in_a_row_[host];
    failed.insert(outcome.id);
    if (failed.size() >= failures_that_count) {
        failed_in_a_row_.erase(host);
        leave_out(host);
        outcome.reason += fmt::format(" ({} tasks in a row failed on {}: it is left out for {} seconds)",
                                      failures_that_count, outcome.worker, options_.leave_out.count());
    }
}

void WorkQueueEngine::leave_out(const std::string& host) {
    work_queue_block_host_with_timeout(queue_.get(), host.c_str(), options_.leave_out.count());
}

void WorkQueueEngine::distrust(const Outcome& outcome) {
    if (++distrusted_[outcome.worker] % failures_that_count == 0) {
        leave_out(outcome.worker);
    }
}

std::size_t WorkQueueEngine::wanted() const {
    work_queue_stats stats{};
    work_queue_get_stats(queue_.get(), &stats);
    // Twice the cores, so that each finds a task waiting; and some, for the workers that are just coming.
    constexpr std::int64_t for_new_workers = 16;
    return static_cast<std::size_t>(2 * std::max<std::int64_t>(stats.total_cores, 0) + for_new_workers);
}

EngineFigures WorkQueueEngine::figures() const {
    work_queue_stats stats{};
    work_queue_get_stats(queue_.get(), &stats);
    EngineFigures figures;
    figures.workers = count(stats.workers_connected);
    figures.running = count(stats.tasks_on_workers);
    figures.joined = count(stats.workers_joined);
    // The library's own number leaves out those that were given up because they did not answer.
    figures.lost = count(stats.workers_removed - stats.workers_released - stats.workers_idled_out);
    figures.resent = resent_;
    figures.busy_seconds =
        seconds(stats.time_send + stats.time_receive + stats.time_status_msgs + stats.time_internal);
    return figures;
}

}  // namespace dumbbell::campaign
