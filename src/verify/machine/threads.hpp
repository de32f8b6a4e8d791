// Threads whose arithmetic is what the bounds rest on, whatever the program around them did to it.
#pragma once
#include <mpfr.h>

#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

#include "verify/machine/environment.hpp"

namespace dumbbell_verify {

/// Threads of their own, all of them over when this is.
class Crew {
  public:
    Crew() = default;
    ~Crew() {
        for (std::thread& thread : threads_) thread.join();
    }
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    /// So many threads do `work`, or as many of them as may start.
    template <class Work>
    void start(std::size_t wanted, Work work) try {
        threads_.reserve(threads_.size() + wanted);
        for (; wanted > 0; --wanted)
            threads_.emplace_back([work] {
                const DefaultEnvironment environment;
                work();
                mpfr_free_cache();
            });
    } catch (const std::exception&) {  // those that started do the work
    }
    [[nodiscard]] bool empty() const { return threads_.empty(); }

  private:
    std::vector<std::thread> threads_;
};

}  // namespace dumbbell_verify
