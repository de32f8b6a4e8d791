#include "campaign/work_queue_engine.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <map>
#include <memory>
#include <optional>

#include "base/deadline.hpp"
#include "campaign/password.hpp"
#include "programs/cli/process.hpp"

using namespace dumbbell_test;
using namespace std::chrono_literals;
using Catch::Matchers::Contains;
using dumbbell::campaign::WorkQueueEngine;
using dumbbell::campaign::WorkQueueOptions;
using End = dumbbell::campaign::Outcome::End;

// LeakSanitizer asks for it: of each queue the library itself leaks some bytes.
extern "C" const char* __lsan_default_suppressions() {  // NOLINT(bugprone-reserved-identifier)
    return "leak:xxstrdup\nleak:work_queue_block_host_with_timeout\n";
}

namespace {

// Understands `campaign work [--limit SECONDS] order result`; the order's first line is a word and what it is
// about.
constexpr const char* stand_in = R"(#!/bin/sh
test "$1 $2" = "campaign work" || exit 9
shift 2
if [ "$1" = --limit ]; then limit=$2; shift 2; fi
read -r word rest < "$1"
case $word in
    say) printf '%s' "$rest" > "$2" ;;
    order) cp "$1" "$2" ;;
    limit) printf '%s' "$limit" > "$2" ;;
    input) cat "$rest" > "$2" ;;
    sleep) sleep "$rest"; echo slept > "$2" ;;
    begun) touch "$rest"; exec sleep 100000 ;;
    hang) exec sleep 1000 ;;
    fail) echo noise; printf '%s\n \n' "$rest" >&2; exit 1 ;;
    long) echo half > "$2"; exit 3 ;;
    crash) kill -SEGV $$ ;;
    none) ;;
    link) echo target > target; ln -s target "$2" ;;
    folder) mkdir "$2"; echo inside > "$2/file" ;;
    pipe) mkfifo "$2" ;;
    zeros) head -c "$rest" /dev/zero > "$2" ;;
esac
)";

// What a campaign has: a folder with a password, and a program that does what its orders say.
class Site {
  public:
    Site() : password_(dumbbell::campaign::password_file(folder_.path())), program_(folder_ / "stand-in") {
        write_file(program_, stand_in);
        ::chmod(program_.c_str(), 0755);
    }

    [[nodiscard]] WorkQueueOptions options() const {
        WorkQueueOptions options;
        options.port = 0;
        options.password_file = password_;
        options.program = program_;
        return options;
    }

    [[nodiscard]] std::unique_ptr<Process> worker(int port, const std::string& password,
                                                  const std::string& cores = "1") const {
        return std::make_unique<Process>(
            std::vector<std::string>{"work_queue_worker", "--password", password, "--cores", cores,
                                     "--timeout", "600", "--max-backoff", "1", "--parent-death", "--workdir",
                                     folder_.path(), "127.0.0.1", std::to_string(port)});
    }
    [[nodiscard]] std::unique_ptr<Process> worker(int port) const { return worker(port, password_); }

    [[nodiscard]] const TemporaryFolder& folder() const { return folder_; }

  private:
    TemporaryFolder folder_;
    std::string password_;
    std::string program_;
};

dumbbell::campaign::Task task(const std::string& id, const std::string& order) {
    return {id, order + "\n", {}, {}};
}

dumbbell::campaign::Outcome next(WorkQueueEngine& engine) {
    auto outcome = engine.wait(1h);
    REQUIRE(outcome);
    return *outcome;
}

dumbbell::campaign::Outcome outcome(WorkQueueEngine& engine, const std::string& order) {
    engine.submit(task("one", order));
    return next(engine);
}

std::string reason(WorkQueueEngine& engine, const std::string& order) {
    const auto given = outcome(engine, order);
    CHECK(given.end == End::failed);
    CHECK(given.result.empty());
    return given.reason;
}

}  // namespace

TEST_CASE("results come back, whatever their bytes, with their tasks' names") {
    const Site site;
    WorkQueueEngine engine(site.options());
    const auto worker = site.worker(engine.port());

    const auto said = outcome(engine, "say hello");
    CHECK(said.end == End::done);
    CHECK(said.id == "one");
    CHECK(said.result == "hello");
    CHECK(said.reason.empty());
    CHECK_FALSE(said.worker.empty());

    CHECK(outcome(engine, "zeros 100000").result == std::string(100000, '\0'));
    CHECK(outcome(engine, "zeros 0").result.empty());
    const std::string order = "order $(touch escaped); `id`\n\xff\x01 'quoted'\n" + std::string(300000, 'x');
    CHECK(outcome(engine, order).result == order + "\n");

    write_file(site.folder() / "a-piece.txt", "of a certificate");
    engine.submit({"two", "input a-piece.txt\n", {site.folder() / "a-piece.txt"}, 12.5s});
    CHECK(next(engine).result == "of a certificate");
    engine.submit({"three", "limit\n", {}, 12.5s});
    CHECK(next(engine).result == "12.500");

    const auto figures = engine.figures();
    CHECK(figures.workers == 1);
    CHECK(figures.joined == 1);
    CHECK(figures.lost == 0);
    CHECK(figures.resent == 0);
    CHECK(figures.running == 0);
    CHECK(figures.busy_seconds > 0);
    CHECK(engine.wanted() >= 2);
}

TEST_CASE("a task that gives no result says why") {
    const Site site;
    auto options = site.options();
    options.largest_result = 1000;
    options.leave_out = 1s;
    WorkQueueEngine engine(options);
    const auto worker = site.worker(engine.port());

    CHECK(outcome(engine, "long").end == End::too_long);
    CHECK(outcome(engine, "long").result.empty());
    CHECK(reason(engine, "fail of another version") == "of another version");
    CHECK(reason(engine, "fail \x1b[31mred\xff") == "?[31mred?");
    CHECK(reason(engine, "fail " + std::string(500, 'x')) == std::string(200, 'x') + "...");
    CHECK(reason(engine, "crash").size() < 300);
    CHECK(reason(engine, "none") == "no result");
    CHECK(reason(engine, "link") == "no result");
    CHECK(reason(engine, "folder") == "no result");
    CHECK(reason(engine, "pipe") == "no result");
    CHECK(outcome(engine, "zeros 1000").end == End::done);
    CHECK(reason(engine, "zeros 1001") == "a result of more than 1000 bytes");
}

TEST_CASE("a task has its time, also on a worker of several cores") {
    const Site site;
    WorkQueueEngine engine(site.options());
    const auto worker = site.worker(engine.port(), site.options().password_file, "3");
    for (const char* seconds : {"3", "2", "1"}) {  // the end of one has the worker look at the others
        engine.submit({seconds, std::string("sleep ") + seconds + "\n", {}, 600s});
    }
    for (int i = 0; i < 3; ++i) {
        const auto given = next(engine);
        CHECK(given.end == End::done);
        CHECK(given.result == "slept\n");
    }
}

TEST_CASE("a task that does not keep to its limit is stopped") {
    const Site site;
    auto options = site.options();
    options.overtime = 1s;
    WorkQueueEngine engine(options);
    const auto worker = site.worker(engine.port());
    engine.submit({"one", "hang\n", {}, 0.5s});
    const auto given = next(engine);
    CHECK(given.end == End::too_long);
    CHECK(given.seconds < 900);  // it would take a thousand
}

TEST_CASE("a worker that is killed costs no task, and none comes twice") {
    const Site site;
    WorkQueueEngine engine(site.options());
    const auto first = site.worker(engine.port());
    const auto second = site.worker(engine.port());
    while (engine.figures().joined < 2) {
        CHECK_FALSE(engine.wait(10ms));
    }
    std::map<std::string, int> outcomes;
    for (int i = 0; i < 50; ++i) {
        engine.submit(task(std::to_string(i), "sleep 0.1"));
    }
    for (int i = 0; i < 50; ++i) {
        if (i == 10) {
            first->send(SIGSTOP);  // it has a task, or is given one before five others are done
        }
        if (i == 15) {
            first->kill();
        }
        const auto given = next(engine);
        CHECK(given.end == End::done);
        ++outcomes[given.id];
    }
    CHECK(outcomes.size() == 50);
    CHECK_FALSE(engine.wait(10ms));
    CHECK(engine.figures().workers == 1);
    CHECK(engine.figures().lost == 1);
    CHECK(engine.figures().resent >= 1);
}

TEST_CASE("a worker that falls silent is given up, and its task is done by another") {
    const Site site;
    auto options = site.options();
    options.ask_after = 1s;
    options.answer_within = 5s;  // the other one answers in time on a busy machine, too
    WorkQueueEngine engine(options);
    const auto silent = site.worker(engine.port());
    engine.submit(task("one", "sleep 1"));
    while (engine.figures().running == 0) {
        CHECK_FALSE(engine.wait(10ms));
    }
    silent->send(SIGSTOP);
    const auto other = site.worker(engine.port());
    const auto given = next(engine);
    CHECK(given.id == "one");
    CHECK(given.result == "slept\n");
    CHECK(engine.figures().lost == 1);
    CHECK(engine.figures().resent >= 1);
    CHECK(engine.figures().workers == 1);
}

TEST_CASE("a worker that takes its leave is not lost") {
    const Site site;
    WorkQueueEngine engine(site.options());
    Process worker({"work_queue_worker", "--password", engine.place().password_file, "--cores", "1",
                    "--timeout", "3", "--workdir", site.folder().path(), "127.0.0.1",
                    std::to_string(engine.port())});
    CHECK(outcome(engine, "say hello").result == "hello");
    while (engine.figures().workers > 0) {
        CHECK_FALSE(engine.wait(100ms));
    }
    CHECK(engine.figures().joined == 1);
    CHECK(engine.figures().lost == 0);
    worker.send(SIGTERM);  // it would look for its manager for some time
}

TEST_CASE("a worker without the password gets nothing") {
    const Site site;
    WorkQueueEngine engine(site.options());
    const TemporaryFolder elsewhere;
    const auto worker = site.worker(engine.port(), dumbbell::campaign::password_file(elsewhere.path()));
    engine.submit(task("one", "say hello"));
    CHECK_FALSE(engine.wait(3s));
    CHECK(engine.figures().joined == 0);
    const auto right = site.worker(engine.port());
    CHECK(next(engine).result == "hello");
}

TEST_CASE("a manager that is gone leaves its workers to the next one") {
    const Site site;
    auto options = site.options();
    auto engine = std::make_unique<WorkQueueEngine>(options);
    options.port = engine->port();
    const auto worker = site.worker(options.port);
    CHECK(outcome(*engine, "say first").result == "first");
    engine->submit(task("cancelled", "sleep 1000"));
    while (engine->figures().running == 0) {
        CHECK_FALSE(engine->wait(10ms));
    }
    engine.reset();

    WorkQueueEngine restarted(options);
    CHECK(outcome(restarted, "say second").result == "second");
}

TEST_CASE("a task that is no longer wanted ends, although its worker was too late to make its group") {
    const Site site;
    auto options = site.options();
    auto engine = std::make_unique<WorkQueueEngine>(options);
    options.port = engine->port();
    const Process worker({"env", "LD_PRELOAD=" DUMBBELL_LATE_GROUP, "work_queue_worker", "--password",
                          options.password_file, "--cores", "1", "--timeout", "600", "--max-backoff", "1",
                          "--parent-death", "--workdir", site.folder().path(), "127.0.0.1",
                          std::to_string(options.port)});
    const std::string mark = site.folder() / "begun";
    engine->submit(task("cancelled", "begun " + mark));
    while (!std::filesystem::exists(mark)) {
        CHECK_FALSE(engine->wait(10ms));
    }
    engine.reset();

    WorkQueueEngine restarted(options);
    CHECK(outcome(restarted, "say second").result == "second");
}

TEST_CASE("a host on which everything fails is left out for some time") {
    const Site site;
    auto options = site.options();
    options.leave_out = 8s;
    WorkQueueEngine engine(options);
    const auto worker = site.worker(engine.port());
    for (const char* id : {"1", "2", "3", "4"}) {
        engine.submit(task(id, "fail to start"));
    }
    CHECK(next(engine).reason == "to start");
    CHECK(next(engine).reason == "to start");
    CHECK_THAT(next(engine).reason, Contains("to start (3 tasks in a row failed on ") &&
                                        Contains(": it is left out for 8 seconds)"));
    CHECK_FALSE(engine.wait(2s));
    CHECK(engine.figures().workers == 1);
    CHECK(next(engine).reason == "to start");
    CHECK(engine.figures().lost == 0);
}

TEST_CASE("a signal ends the waiting soon") {
    const Site site;
    WorkQueueEngine engine(site.options());
    dumbbell::stop_signal = SIGTERM;
    const auto start = std::chrono::steady_clock::now();
    CHECK_FALSE(engine.wait(1h));
    dumbbell::stop_signal = 0;
    CHECK(std::chrono::steady_clock::now() - start < 30min);
}

TEST_CASE("the program itself is sent to the workers if there is none") {
    const Site site;
    auto options = site.options();
    options.program.clear();
    WorkQueueEngine engine(options);
    const auto worker = site.worker(engine.port());
    // This program runs there, finds no test of the name "campaign", and ends well. Were it not there, the
    // reason would be another one.
    CHECK(reason(engine, "say hello") == "no result");
    options.program = site.folder() / "none";
    WorkQueueEngine without(options);
    const auto other = site.worker(without.port());
    CHECK_THAT(reason(without, "say hello"), Contains("not found"));
}

TEST_CASE("the printed line starts a worker") {
    const Site site;
    WorkQueueEngine engine(site.options());
    const Process worker({"env", "TMPDIR=" + site.folder().path(), "sh", "-c",
                          "exec " + dumbbell::campaign::worker_command(engine.place(), "127.0.0.1")});
    CHECK(outcome(engine, "say hello").result == "hello");
}

TEST_CASE("a program that a shell would not take as it is is refused") {
    const Site site;
    auto options = site.options();
    for (const char* program :
         {"dumbbell", "/usr/bin/dumbbell; id", "/a b", "/$HOME/d", "/a\nb", "/~/d", "/a*"}) {
        options.program = program;
        CHECK_THROWS_WITH(WorkQueueEngine(options), Contains("cannot be the program on the workers"));
    }
}
