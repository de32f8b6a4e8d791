#include "apart.hpp"

#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <new>
#include <stdexcept>
#include <system_error>

namespace dumbbell_mutation {
namespace {

constexpr unsigned most_jobs = 64;

/// Seen by all processes.
struct Shared {
    std::atomic<std::size_t> next;
    std::atomic<std::size_t> at[most_jobs];  ///< the item that a worker is at
};
static_assert(std::atomic<std::size_t>::is_always_lock_free);

[[noreturn]] void fail(const char* doing) { throw std::system_error(errno, std::generic_category(), doing); }

void limit_time(int seconds) {
    const itimerval timer{{0, 0}, {seconds, 0}};
    setitimer(ITIMER_PROF, &timer, nullptr);
}

/// A worker's life: one line for each finished item, written at once.
void work_on(Shared& shared, unsigned worker, std::size_t n, int seconds, int results,
             const std::function<std::string(std::size_t)>& work) {
    for (std::size_t i = shared.next++; i < n; i = shared.next++) {
        shared.at[worker] = i;
        limit_time(seconds);
        const std::string line = std::to_string(i) + '\t' + work(i) + '\n';
        limit_time(0);
        if (write(results, line.data(), line.size()) != static_cast<ssize_t>(line.size()))
            fail("writing results");
    }
}

class Pool {
  public:
    Pool(std::size_t n, int seconds, const std::function<std::string(std::size_t)>& work)
        : n_(n), seconds_(seconds), work_(work), results_(std::tmpfile(), std::fclose), ended_(n) {
        if (!results_) fail("making a temporary file");
        void* memory =
            mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        if (memory == MAP_FAILED) fail("sharing memory");
        shared_ = new (memory) Shared{};
    }
    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;
    ~Pool() { munmap(shared_, sizeof(Shared)); }

    std::vector<Ended> run(unsigned jobs) {
        std::vector<pid_t> workers(jobs);
        for (unsigned i = 0; i < jobs; ++i) workers[i] = start(i);
        for (unsigned alive = jobs; alive > 0;) {
            int status = 0;
            const pid_t pid = wait(&status);
            if (pid < 0) fail("waiting for a worker");
            unsigned i = 0;
            while (i < jobs && workers[i] != pid) ++i;
            if (i == jobs) continue;
            --alive;
            if (WIFEXITED(status) && WEXITSTATUS(status) == 0) continue;
            // A sanitizer's report ends the process with an exit code.
            ended_[shared_->at[i]].signal = WIFSIGNALED(status) ? WTERMSIG(status) : SIGABRT;
            workers[i] = start(i);
            ++alive;
        }
        collect();
        return std::move(ended_);
    }

  private:
    pid_t start(unsigned worker) {
        std::fflush(nullptr);
        const pid_t pid = fork();
        if (pid < 0) fail("starting a worker");
        if (pid > 0) return pid;
        try {
            work_on(*shared_, worker, n_, seconds_, fileno(results_.get()), work_);
        } catch (const std::exception& error) {
            std::fprintf(stderr, "mutation: %s\n", error.what());
            std::_Exit(1);
        }
        std::_Exit(0);
    }
    void collect() {
        std::rewind(results_.get());
        std::string line;
        for (int c = std::fgetc(results_.get()); c != EOF; c = std::fgetc(results_.get())) {
            if (c != '\n') {
                line += static_cast<char>(c);
                continue;
            }
            const std::size_t tab = line.find('\t');
            ended_.at(std::stoul(line)).result = line.substr(tab + 1);
            line.clear();
        }
    }

    std::size_t n_;
    int seconds_;
    const std::function<std::string(std::size_t)>& work_;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> results_;
    std::vector<Ended> ended_;
    Shared* shared_ = nullptr;
};

}  // namespace

std::vector<Ended> run_apart(std::size_t n, unsigned jobs, int seconds,
                             const std::function<std::string(std::size_t)>& work) {
    return Pool(n, seconds, work).run(std::min(jobs, most_jobs));
}

}  // namespace dumbbell_mutation
