#include "flight/batch/count.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "base/error.hpp"
#include "flight/batch/backends.hpp"
#include "number/rounding.hpp"  // refuses compilers that break IEEE arithmetic
#include "number/self_test.hpp"

namespace dumbbell::flight::batch {
namespace {

constexpr const char* variable = "DUMBBELL_BACKEND";

Backend named_backend(std::string_view wanted) {
    std::string known;
    for (const Backend backend : backends()) {
        if (name(backend) == wanted) {
            return backend;
        }
        known += fmt::format("{}{}", known.empty() ? "" : ", ", name(backend));
    }
    throw InputError(
        fmt::format("{}: this machine has {}: set it to one of them, or unset it", variable, known));
}

}  // namespace

std::string_view name(Backend backend) {
    switch (backend) {
        case Backend::plain:
            return "plain";
        case Backend::avx2:
            return "avx2";
        default:
            return "avx512";
    }
}

std::vector<Backend> backends() {
    std::vector<Backend> found{Backend::plain};
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2")) {
        found.push_back(Backend::avx2);
    }
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) {
        found.push_back(Backend::avx512);
    }
#endif
    return found;
}

Backend chosen_backend() {
    static const Backend chosen = [] {
        const char* wanted = std::getenv(variable);
        return wanted == nullptr ? backends().back() : named_backend(wanted);
    }();
    return chosen;
}

namespace {

struct Kernels {
    void (*at_most)(const Query*, Answer*, long, Stop);
    void (*at_least)(const Query*, Answer*, long, Stop);
};

Kernels kernels(Backend backend) {
    switch (backend) {
#if defined(__x86_64__)
        case Backend::avx2:
            return {count_at_most_avx2, count_at_least_avx2};
        case Backend::avx512:
            return {count_at_most_avx512, count_at_least_avx512};
#endif
        default:
            return {count_at_most_plain, count_at_least_plain};
    }
}

Stop stop_when(const Interrupted& interrupted) {
    return {[](const void* context) { return (*static_cast<const Interrupted*>(context))(); }, &interrupted};
}

/// What L39 takes for granted of this thread's arithmetic (the packs obey the same control register as plain
/// doubles), and the kernel of its queries: "more than the cap" is a number that doubles can tell from it.
void check(std::span<const Query> queries, std::span<const Answer> answers) {
    require_sound_arithmetic();
    require(queries.size() == answers.size(), "batch: as many answers as queries");
    require(std::ranges::all_of(queries, [](const Query& query) { return query.cap <= greatest_cap; }),
            "batch: the cap of a query is too great");
}

}  // namespace

void count_at_most(std::span<const Query> queries, std::span<Answer> answers, Backend backend,
                   const Interrupted& interrupted) {
    check(queries, answers);
    std::ranges::transform(queries, answers.begin(), [](const Query& query) {
        return Answer{query.cap + 1, false};
    });
    kernels(backend).at_most(queries.data(), answers.data(), static_cast<long>(queries.size()),
                             stop_when(interrupted));
}

void count_at_least(std::span<const Query> queries, std::span<Answer> answers, Backend backend,
                    const Interrupted& interrupted) {
    check(queries, answers);
    std::ranges::fill(answers, Answer{});
    kernels(backend).at_least(queries.data(), answers.data(), static_cast<long>(queries.size()),
                              stop_when(interrupted));
    // The kernel looks at the cap after a collision.
    for (std::size_t i = 0; i < queries.size(); ++i) {
        answers[i].count = std::min(answers[i].count, queries[i].cap);
    }
}

}  // namespace dumbbell::flight::batch
