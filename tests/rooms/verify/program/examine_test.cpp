// Files at the same time: on as many threads as were asked for.
#include "verify/program/examine.hpp"

#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "catch.hpp"
#include "rooms/verify/core/make_certificate.hpp"
#include "verify/input/bytes.hpp"

using namespace dumbbell_verify;

namespace {

/// How many this process has: of `task`, threads; of `fd`, open files.
auto number_of(const std::string& what) {
    namespace fs = std::filesystem;
    return std::distance(fs::directory_iterator("/proc/self/" + what), fs::directory_iterator());
}

/// In the place of the standard input: nothing comes, and no end, before it is ended.
class Silence {
  public:
    Silence() : before_(::dup(STDIN_FILENO)) {
        REQUIRE(::pipe(ends_.data()) == 0);
        ::dup2(ends_[0], STDIN_FILENO);
        ::close(ends_[0]);
    }
    ~Silence() {
        ::dup2(before_, STDIN_FILENO);
        ::close(before_);
    }
    void end() const { ::close(ends_[1]); }

  private:
    int before_;
    std::array<int, 2> ends_{};
};

}  // namespace

TEST_CASE("examine_all works on as many threads and files as it may, and on no more") {
    using namespace std::chrono_literals;
    for (const unsigned at_once : {2U, 3U}) {
        const Silence input;
        const auto before = number_of("task"), open_before = number_of("fd");
        std::size_t reported = 0;
        {
            const std::vector<Job> jobs(5, Job{"-", {}});
            const std::jthread caller(
                [&] { reported = examine_all(jobs, at_once, [](const Result&) {}).size(); });
            while (number_of("task") < before + 1 + at_once || number_of("fd") < open_before + at_once)
                std::this_thread::sleep_for(1ms);
            std::this_thread::sleep_for(200ms);  // for one too many to show itself
            CHECK(number_of("task") == before + 1 + at_once);
            CHECK(number_of("fd") == open_before + at_once);  // a file for each
            input.end();
        }
        CHECK(reported == 5);
    }
}

TEST_CASE("a named pipe is refused, and left closed") {
    const make::File pipe("");
    ::unlink(pipe.path().c_str());
    REQUIRE(::mkfifo(pipe.path().c_str(), 0600) == 0);
    const auto before = number_of("fd");
    CHECK_THROWS_WITH(InputFile(pipe.path()), "a named pipe: give `-` and let the shell redirect it");
    CHECK(number_of("fd") == before);
}

TEST_CASE("a pipe that is empty for now is waited for, whatever signals come") {
    std::array<int, 2> ends{};
    REQUIRE(::pipe(ends.data()) == 0);
    struct sigaction handler {};
    handler.sa_handler = [](int) {};  // without SA_RESTART: calls are interrupted
    REQUIRE(::sigaction(SIGALRM, &handler, nullptr) == 0);
    const itimerval often{{0, 2000}, {0, 2000}}, never{};
    std::thread late([&] {
        sigset_t all;
        ::sigfillset(&all);
        ::pthread_sigmask(SIG_BLOCK, &all, nullptr);
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        CHECK(::write(ends[1], "late", 4) == 4);
        ::close(ends[1]);
    });
    REQUIRE(::setitimer(ITIMER_REAL, &often, nullptr) == 0);
    InputFile file("/dev/fd/" + std::to_string(ends[0]));
    std::array<char, 10> bytes{};
    CHECK(file.read(bytes) == 4);
    CHECK(file.read(bytes) == 0);
    late.join();
    REQUIRE(::setitimer(ITIMER_REAL, &never, nullptr) == 0);
    ::close(ends[0]);
}

TEST_CASE("a result tells why a file is refused") {
    const make::File file(make::mutated(make::ten(), "upper 4", "upper 3"));
    const Result result = examine({file.path(), {}});
    CHECK(result.why.text == "not certified: 1 + a + b <= U");
}

TEST_CASE("without memory to unpack a file nothing is said of it") {
    CHECK_THROWS_AS(need_memory(false), std::bad_alloc);
    need_memory(true);
}
