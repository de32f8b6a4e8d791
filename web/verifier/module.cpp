// dumbbell-verify as a WebAssembly module: what the page, and the tests under node, call. The file that it
// reads is the standard input, the function fd_read of module.js.
#include <gmp.h>

#include <cerrno>
#include <cstdlib>

#include "verify/machine/environment.hpp"
#include "verify/machine/meter.hpp"
#include "verify/program/claim_options.hpp"
#include "verify/program/escape.hpp"
#include "verify/program/json.hpp"
#include "verify/program/sentence.hpp"
#include "verify/program/summary.hpp"

namespace dumbbell_verify {
namespace {

/// Of the page: how much was done so far, in seconds of a core, and how many pieces of all that there are.
extern "C" __attribute__((import_module("page"), import_name("progress"))) void show_progress(double seconds,
                                                                                              double read,
                                                                                              double pieces);
void progress() {
    show_progress(static_cast<double>(Watched::work) / units_per_second, static_cast<double>(Watched::read),
                  static_cast<double>(Watched::pieces));
}

/// The options that state a claim, and those for what it may cost, as of the program.
Request settings_of(std::vector<std::string> words) {
    Request settings;
    Arguments given(std::move(words));
    ClaimWords claim;
    while (given.next()) {
        if (claim_option(given, claim)) continue;
        given.once();
        if (given.option == "--budget")
            settings.budget = given.time();
        else if (given.option == "--precision")
            settings.precision = static_cast<unsigned>(given.number(53, 4096));
        else if (given.option == "--max-bits")
            settings.max_bits = static_cast<unsigned>(given.number(53, 4096));
        else
            throw std::invalid_argument("unknown option " + given.word.substr(0, 60));
    }
    state_claim(claim, settings);
    return settings;
}

std::string answer_to(std::vector<std::string> words) try {
    const Job job{"/dev/stdin", settings_of(std::move(words))};
    const Result result = examine(job);
    return R"({"line":)" + json_string(verdict_line(result)) + R"(,"sentence":)" +
           json_string(result.is_right() ? sentence(result) : "") + R"(,"result":)" + json(result) + "}";
} catch (const std::invalid_argument& error) {
    return R"({"usage":)" + json_string(error.what()) + "}";
}

std::string room, answer;

/// GMP and MPFR cannot be told that there is no memory. The page hears of every trap.
void* allocated(void* block) {
    if (!block) __builtin_trap();
    return block;
}

}  // namespace
}  // namespace dumbbell_verify

extern "C" {

// What the library of C asks of a system. There is none; there are no files but the standard input, and
// nothing asks more of that. A signal is one that GMP raises, and never comes back from.
void emscripten_notify_memory_growth(std::size_t) {}
__attribute__((target("bulk-memory"))) void* memcpy(void* to, const void* from, std::size_t size) {
    return __builtin_memcpy(to, from, size);  // one instruction
}
void __call_sighandler(void (*)(int), int) { __builtin_trap(); }
int __syscall_dup(int) { return -ENOSYS; }
int __syscall_poll(int, int, int) { return -ENOSYS; }
int __syscall_fstat64(int, int) { return -ENOSYS; }
int __syscall_stat64(int, int) { return -ENOSYS; }
int __syscall_lstat64(int, int) { return -ENOSYS; }
int __syscall_fstatat64(int, int, int, int) { return -ENOSYS; }

/// Room for this many bytes of options, with a line feed behind each.
__attribute__((export_name("options"))) char* options(std::size_t size) {
    dumbbell_verify::room.resize(size);
    return dumbbell_verify::room.data();
}

/// Verifies the file, once; the answer is JSON, with a zero byte behind it.
__attribute__((export_name("verify"))) const char* verify() {
    using namespace dumbbell_verify;
    const DefaultEnvironment environment;
    mp_set_memory_functions(
        [](std::size_t size) { return allocated(std::malloc(size)); },
        [](void* old, std::size_t, std::size_t size) { return allocated(std::realloc(old, size)); },
        [](void* block, std::size_t) { std::free(block); });
    Shares::watch = progress;
    std::vector<std::string> words;
    for (std::string_view rest = room; !rest.empty();) {
        const std::size_t size = std::min(rest.find('\n'), rest.size() - 1);
        words.emplace_back(rest.substr(0, size));
        rest.remove_prefix(size + 1);
    }
    answer = answer_to(std::move(words));
    return answer.c_str();
}
}
