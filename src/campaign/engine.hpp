#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// A campaign: one claim proved in shards, on one machine or many.
namespace dumbbell::campaign {

/// One shard to be processed.
struct Task {
    std::string id;     ///< of the order: 32 hexadecimal digits
    std::string order;  ///< its text
    /// Files that the order names, which have to lie next to it: regular files, each with a name of its own.
    std::vector<std::string> inputs;
    /// Of work, after which it is given back as too long; nothing: never.
    std::optional<std::chrono::duration<double>> limit;
};

/// What became of a task. Nothing in it is trusted: it comes from another process, or another machine.
struct Outcome {
    enum class End {
        done,      ///< with a result
        too_long,  ///< not finished within the limit
        failed     ///< without a result
    };
    std::string id;
    End end = End::failed;
    std::string result;  ///< done: the bytes of the result
    std::string reason;  ///< failed: why, one printable line
    std::string worker;  ///< where it ran, printable
    double seconds = 0;  ///< of work there
};

/// What the engine itself was busy with so far.
struct EngineFigures {
    std::size_t workers = 0;  ///< that are there now
    std::size_t running = 0;  ///< tasks on workers now
    std::size_t joined = 0;   ///< workers that ever came
    std::size_t lost = 0;     ///< workers that went away without a word
    std::size_t resent = 0;   ///< tasks sent again: their worker was lost, or gave them back without a try
    double busy_seconds = 0;  ///< of its own work: sending, receiving, bookkeeping
};

/// Processes tasks, in any order, each at least once. One thread uses it.
class Engine {
  public:
    Engine() = default;
    virtual ~Engine() = default;
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    /// Accepts a task; returns at once. The task's id is none of those under way.
    virtual void submit(const Task& task) = 0;

    /// The next outcome; nothing if there was none in this time, or a signal asks the program to stop.
    virtual std::optional<Outcome> wait(std::chrono::milliseconds time) = 0;

    /// This outcome's result was not what it should be: its worker is not to be relied on.
    virtual void distrust(const Outcome& outcome) = 0;

    /// The number of tasks that should be under way, so that no worker waits for one.
    [[nodiscard]] virtual std::size_t wanted() const = 0;

    [[nodiscard]] virtual EngineFigures figures() const = 0;
};

}  // namespace dumbbell::campaign
