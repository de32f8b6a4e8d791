// dumbbell-verify: verifies files and prints the results.
#include <gmp.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "verify/machine/environment.hpp"
#include "verify/program/escape.hpp"
#include "verify/program/json.hpp"
#include "verify/program/options.hpp"
#include "verify/program/progress.hpp"
#include "verify/program/summary.hpp"

namespace dumbbell_verify {
namespace {

void complain(const std::exception& error, const char* kind = "") {
    std::fprintf(stderr, "dumbbell-verify: %s%s\n", kind, one_line(error.what()).c_str());
}

/// All that was printed so far must have arrived.
void require_printed() {
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
        throw std::invalid_argument("cannot write to the standard output");
}

void print_line(const std::string& text) { std::printf("%s\n", text.c_str()); }

/// Every file by itself. The verdict of all is the worst.
Verdict verify_each(const Options& options, Progress& progress) {
    const bool several = options.jobs.size() > 1;
    const auto results = examine_all(options.jobs, options.at_once, [&](const Result& r) {
        const auto lock = progress.hidden();
        if (options.json)
            std::printf("%s%s", r.job == options.jobs.data() ? "[" : ",\n", json(r).c_str());
        else if (several && !options.quiet)
            print_line(verdict_line(r) + " file=" + one_line(r.job->file));
        else if (!several && options.quiet)
            print_line(verdict_line(r));
        else if (!several)
            std::fputs(block(r, options.leaves).c_str(), stdout);
        std::fflush(stdout);
    });
    if (options.json)
        print_line("]");
    else if (several)
        print_line(summary_line(results));
    return worst(results);
}

/// GMP and MPFR cannot be told that there is no memory, and would abort.
[[noreturn]] void out_of_memory() {
    std::fputs("dumbbell-verify: resource limit: out of memory\n", stderr);
    std::_Exit(exit_code(Verdict::limit));
}
void* allocate(std::size_t size) {
    void* block = std::malloc(size);
    if (!block) out_of_memory();
    return block;
}
void* reallocate(void* old, std::size_t /*old_size*/, std::size_t size) {
    void* block = std::realloc(old, size);
    if (!block) out_of_memory();
    return block;
}
void release(void* block, std::size_t /*size*/) { std::free(block); }

[[gnu::noinline]] void touch_stack(std::size_t pages) {
    [[maybe_unused]] volatile char page[4096];
    if (pages > 1) touch_stack(pages - 1);
    // After the call, or the compiler would make a loop of it; and at a place that it does not know, or it
    // would take no more of the stack than that.
    page[pages % 4096] = 0;
}
/// The stack of the first thread grows as it is used, and where the threads' stacks have taken all memory it
/// could not: a crash. So it takes as many pages at first as arithmetic with many bits needs, or a quarter of
/// all that there may be; where there is no room for them, it says so.
void take_stack() {
    constexpr rlim_t most = 1 << 18;
    rlimit stack{};
    const bool known = getrlimit(RLIMIT_STACK, &stack) == 0;
    const auto size = static_cast<std::size_t>(known ? std::min(most, stack.rlim_cur / 4) : most);
    void* room = mmap(nullptr, size, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (room == MAP_FAILED) out_of_memory();
    munmap(room, size);
    touch_stack(size / 4096);
}

int verify_all(const Options& options) {
    Verdict verdict = [&] {
        Progress progress(!options.quiet, options.jobs.front().settings.budget);
        return verify_each(options, progress);
    }();
    try {
        require_printed();
    } catch (const std::invalid_argument& error) {
        complain(error);
        verdict = std::max(verdict, Verdict::unreadable);
    }
    return exit_code(verdict);
}

}  // namespace
}  // namespace dumbbell_verify

int main(int argc, char** argv) {
    using namespace dumbbell_verify;
    const DefaultEnvironment environment;
    take_stack();
    std::signal(SIGXFSZ, SIG_IGN);  // output that may not grow any more is like a full disk
    mp_set_memory_functions(allocate, reallocate, release);
    try {
        const Options options = parse_options({argv + std::min(argc, 1), argv + argc});
        if (options.answer.empty()) return verify_all(options);
        std::fputs(options.answer.c_str(), stdout);
        require_printed();
        return 0;
    } catch (const std::invalid_argument& error) {
        complain(error);
        return exit_code(Verdict::unreadable);
    } catch (const std::exception& error) {
        complain(error, "resource limit: ");
        return exit_code(Verdict::limit);
    }
}
