#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "campaign/engine.hpp"
#include "campaign/work_queue_manager.hpp"
#include "campaign/worker_commands.hpp"

struct work_queue_task;

namespace dumbbell::campaign {

struct WorkQueueOptions {
    std::string address = "127.0.0.1";  ///< to listen on, numeric: this machine's programs only
    int port = 9123;                    ///< to listen on; 0: any free one
    std::string password_file;          ///< what workers have to know, see read_password
    /// The program on the workers' machines, an absolute path of characters [A-Za-z0-9._/-]; empty: the
    /// running program itself is sent to each worker, once.
    std::string program;
    /// A worker that has not spoken for `ask_after` is asked whether it is there, and given up if it does not
    /// answer within `answer_within`: a host that is cut off costs a minute, and a network that hangs for
    /// some seconds costs nothing. A worker computes in a process of its own, and answers meanwhile.
    std::chrono::seconds ask_after{30};
    std::chrono::seconds answer_within{15};
    std::chrono::seconds overtime{60};                    ///< beyond twice its limit a task is stopped
    std::chrono::seconds leave_out{300};                  ///< a host on which nothing works
    std::size_t largest_result = std::size_t{64} << 20U;  ///< bytes
};

/// Works tasks off on the workers of Work Queue (`work_queue_worker`), which come and go as they like: a task
/// whose worker is lost is sent to another one, `most_tries` times in all. A task takes one core. Nothing
/// that comes from a worker is believed, or written to a file: the library lets a worker name the file that
/// it gives back, so that results come as the output of a command instead. A host on which three different
/// tasks in a row failed is left out for some time. The end of the object cancels what is under way; its
/// workers wait for another manager, until they have been idle for the time that they were started with.
class WorkQueueEngine : public Engine {
  public:
    /// Listens from here on. Throws InputError (saying what to do) if that cannot be, or the password or the
    /// program cannot be used.
    explicit WorkQueueEngine(WorkQueueOptions options);
    ~WorkQueueEngine() override;
    WorkQueueEngine(const WorkQueueEngine&) = delete;
    WorkQueueEngine& operator=(const WorkQueueEngine&) = delete;

    /// Precondition: the inputs' own names are of [A-Za-z0-9._-] and none of order, result, log, dumbbell.
    void submit(const Task& task) override;

    /// The library counts whole seconds: may take up to one longer, and notices a signal as late. The
    /// `worker` of the outcome is the name of its host, as told by itself.
    std::optional<Outcome> wait(std::chrono::milliseconds time) override;

    /// At every third such outcome its host is left out for some time.
    void distrust(const Outcome& outcome) override;

    [[nodiscard]] std::size_t wanted() const override;

    /// `resent` counts for tasks whose outcome is there.
    [[nodiscard]] EngineFigures figures() const override;

    [[nodiscard]] const std::string& address() const { return options_.address; }
    [[nodiscard]] int port() const { return options_.port; }
    [[nodiscard]] ManagerPlace place() const {
        return {options_.address, options_.port, options_.password_file};
    }

    static constexpr int most_tries = 10;

  private:
    /// A folder of this program's own, which is gone in the end.
    class PrivateFolder {
      public:
        PrivateFolder();
        ~PrivateFolder();
        PrivateFolder(const PrivateFolder&) = delete;
        PrivateFolder& operator=(const PrivateFolder&) = delete;
        [[nodiscard]] const std::filesystem::path& path() const { return path_; }

      private:
        std::filesystem::path path_;
    };

    [[nodiscard]] std::string command(const Task& task) const;
    [[nodiscard]] Outcome outcome_of(const work_queue_task& task) const;
    void count_failures(const std::string& host, Outcome& outcome);
    void leave_out(const std::string& host);

    WorkQueueOptions options_;
    std::optional<PrivateFolder> copy_;  ///< of the running program, if it is sent
    WorkQueueManager queue_;
    std::map<int, work_queue_task*> under_way_;
    std::map<std::string, std::set<std::string>> failed_in_a_row_;  ///< host to tasks
    std::map<std::string, std::size_t> distrusted_;  ///< host to its outcomes that were not to be relied on
    std::size_t resent_ = 0;
};

}  // namespace dumbbell::campaign
