// A program of its own, in which only as many threads may start as a test says, as in a container with a
// limit.
#include <dlfcn.h>
#include <pthread.h>

#include <atomic>
#include <cerrno>

#include "catch.hpp"
#include "dumbbell/certify.hpp"
#include "dumbbell/error.hpp"
#include "dumbbell/verify.hpp"
#include "temporary_folder.hpp"

using namespace dumbbell::api;
using dumbbell_test::contents;

namespace {
std::atomic<int> may_start = 1000;
}

extern "C" [[gnu::visibility("default")]] int pthread_create(pthread_t* thread,
                                                             const pthread_attr_t* attributes,
                                                             void* (*run)(void*), void* argument) {
    static const auto real = reinterpret_cast<decltype(&pthread_create)>(dlsym(RTLD_NEXT, "pthread_create"));
    return may_start-- > 0 ? real(thread, attributes, run, argument) : EAGAIN;
}

namespace {

const std::string stairs = DUMBBELL_CERTIFICATES "/stairs-1-100.dbc";

struct Said {
    bool certified = false, verified = false, is_short = false, limit = false;
};

/// What certify and verify say on a thread with 64 KiB of stack when no other one may start.
void* on_little_stack(void* given) {
    Said& said = *static_cast<Said*>(given);
    try {
        said.certified = certify(MassRatio("10")).complete();
    } catch (const ResourceError&) {
        said.is_short = true;
    }
    const Verdict verdict = verify(stairs, {"1:100", 10}).verdict;
    said.verified = verdict == Verdict::verified;
    said.limit = verdict == Verdict::limit;
    return nullptr;
}

}  // namespace

TEST_CASE("Where fewer threads may start than there are jobs, those that do have the same results") {
    for (const int threads : {0, 1, 2, 5}) {
        CAPTURE(threads);
        may_start = threads;
        CHECK(certify(MassRatio("1:100"), {.jobs = 8}).certificate == contents(stairs));
        CHECK(may_start < 0);
        may_start = threads;
        CHECK(verify(stairs, {"1:100", 10}, 8));
        CHECK(may_start < 0);
    }
}

TEST_CASE("Where a thread has too little stack and no other one may start, that is said") {
    Said said;
    pthread_attr_t attributes;
    pthread_t thread{};
    REQUIRE(pthread_attr_init(&attributes) == 0);
    REQUIRE(pthread_attr_setstacksize(&attributes, 64 << 10) == 0);
    may_start = 1;
    REQUIRE(pthread_create(&thread, &attributes, on_little_stack, &said) == 0);
    REQUIRE(pthread_join(thread, nullptr) == 0);
    REQUIRE(pthread_attr_destroy(&attributes) == 0);
    CHECK((said.is_short && said.limit && !said.certified && !said.verified));
}
