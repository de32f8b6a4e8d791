#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

/// Work of the library while other threads of Python go on, and Ctrl-C ends it.
namespace dumbbell::python {

/// Whether Python's signal handlers have raised an exception (Ctrl-C: KeyboardInterrupt): asked by the work,
/// from any thread. The thread that called runs them, now and then.
class Signals {
  public:
    bool operator()() {
        if (std::this_thread::get_id() != caller_ || raised_ || Clock::now() < next_) {
            return raised_;
        }
        const pybind11::gil_scoped_acquire python;
        raised_ = PyErr_CheckSignals() != 0;
        next_ = Clock::now() + std::chrono::milliseconds(50);
        return raised_;
    }

    /// Once the work has ended: goes on with what they have raised.
    void rethrow() const {
        if (raised_) {
            throw pybind11::error_already_set();
        }
    }

  private:
    using Clock = std::chrono::steady_clock;

    const std::thread::id caller_ = std::this_thread::get_id();
    std::atomic<bool> raised_ = false;
    Clock::time_point next_ = Clock::now();
};

/// work(stopped) without the lock of the interpreter. Precondition: this thread has it, and `work` touches
/// nothing of Python.
template <class Work>
auto running(const Work& work) {
    Signals signals;
    auto result = [&] {
        const pybind11::gil_scoped_release others;
        return work(std::function<bool()>(std::ref(signals)));
    }();
    signals.rethrow();
    return result;
}

}  // namespace dumbbell::python
