#pragma once

#include <pybind11/pybind11.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

/// Work of the library while other threads of Python go on, and Ctrl-C ends it.
namespace dumbbell::python {

/// This thread in the library, without the lock of the interpreter. When the interpreter ends, Python would
/// end a thread that asks for its lock, and the process with it if there is C++ on that thread's stack: so it
/// sleeps from then on.
class Outside {
  public:
    Outside() {
        ++inside;
        state_ = PyEval_SaveThread();
        if (is_over()) {
            sleep();
        }
    }
    ~Outside() {
        if (!locked()) {
            sleep();
        }
        --inside;
    }
    Outside(const Outside&) = delete;
    Outside& operator=(const Outside&) = delete;

    /// Asked by the work, from any thread: whether Python's signal handlers have raised an exception (Ctrl-C:
    /// KeyboardInterrupt), or the interpreter ends. The thread that called runs them, now and then.
    bool stopped() {
        if (raised_ || is_over()) {
            return true;
        }
        if (std::this_thread::get_id() != caller_ || Clock::now() < next_ || !locked()) {
            return false;
        }
        raised_ = PyErr_CheckSignals() != 0;
        state_ = PyEval_SaveThread();
        next_ = Clock::now() + std::chrono::milliseconds(50);
        return raised_;
    }
    [[nodiscard]] bool raised() const { return raised_; }

    /// Python calls it before it ends: the work of other threads ends, and is waited for, but not for ever.
    static void interpreter_ends() {
        constexpr int most = 2000;  // milliseconds
        if (PyThreadState_Get()->interp != PyInterpreterState_Main()) {
            return;
        }
        last = std::this_thread::get_id();
        ending = true;
        const pybind11::gil_scoped_release others;
        for (int i = 0; i < most && inside > 0; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
    /// Of a forked process, where the other threads are not.
    static void forked() { inside = 0; }

  private:
    using Clock = std::chrono::steady_clock;

    [[noreturn]] static void sleep() {
        --inside;
        while (true) {
            ::pause();
        }
    }
    [[nodiscard]] bool is_over() const { return ending && caller_ != last; }

    /// Takes the lock, unless the interpreter ends: who is inside has it before that goes on.
    bool locked() {
        if (is_over()) {
            return false;
        }
        PyEval_RestoreThread(state_);
        return true;
    }

    static inline std::atomic<int> inside = 0;  ///< threads
    static inline std::atomic<bool> ending = false;
    static inline std::thread::id last;  ///< that ends it

    const std::thread::id caller_ = std::this_thread::get_id();
    PyThreadState* state_ = nullptr;
    std::atomic<bool> raised_ = false;
    Clock::time_point next_ = Clock::now();
};

/// work(stopped) without the lock of the interpreter. Precondition: this thread has it, and `work` touches
/// nothing of Python.
template <class Work>
auto running(const Work& work) {
    bool raised = false;
    auto result = [&] {
        Outside outside;
        auto done = work(std::function<bool()>([&] { return outside.stopped(); }));
        raised = outside.raised();
        return done;
    }();
    if (raised) {
        throw pybind11::error_already_set();
    }
    return result;
}

}  // namespace dumbbell::python
