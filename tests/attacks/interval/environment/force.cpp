// To be preloaded: spoils the arithmetic of a program from outside, as a badly built library would. x86-64
// only.
//   DUMBBELL_FORCE_SSE=HEX    bits that are set in MXCSR (8000 flush to zero, 40 denormals are zero, 2000
//   round
//                             down, 4000 round up, 6000 towards zero)
//   DUMBBELL_FORCE_X87=HEX    bits that are set in the x87 control word (400 down, 800 up, c00 towards zero)
//   DUMBBELL_FORCE_TRAPS=HEX  exceptions that end the program (1 invalid, 4 division by zero, 8 overflow, 10
//   underflow,
//                             20 inexact: 3d all of them)
//   DUMBBELL_FORCE_THREADS=N  only so many threads may start
//   DUMBBELL_FORCE_IN=main    in the thread that starts (and so in those that it starts)
//                     threads in every new thread only
#include <dlfcn.h>
#include <pthread.h>
#include <xmmintrin.h>

#include <atomic>
#include <cerrno>
#include <cfenv>
#include <cstdlib>
#include <cstring>
#include <memory>

namespace {

unsigned wanted(const char* name) {
    const char* text = std::getenv(name);
    return text == nullptr ? 0 : static_cast<unsigned>(std::strtoul(text, nullptr, 16));
}

void spoil() {
    _mm_setcsr(_mm_getcsr() | wanted("DUMBBELL_FORCE_SSE"));
    unsigned short control = 0;
    asm volatile("fnstcw %0" : "=m"(control));
    control = static_cast<unsigned short>(control | wanted("DUMBBELL_FORCE_X87"));
    asm volatile("fldcw %0" : : "m"(control));
    feenableexcept(static_cast<int>(wanted("DUMBBELL_FORCE_TRAPS")));
}

/// Whether one more thread may start.
bool may_start() {
    static std::atomic<int> started = 0;
    const char* most = std::getenv("DUMBBELL_FORCE_THREADS");
    return most == nullptr || started++ < std::atoi(most);
}

bool in(const char* where) {
    const char* chosen = std::getenv("DUMBBELL_FORCE_IN");
    return chosen != nullptr && std::strcmp(chosen, where) == 0;
}

struct Start {
    void* (*run)(void*);
    void* argument;
};

void* spoiled(void* data) {
    const std::unique_ptr<Start> start(static_cast<Start*>(data));
    spoil();
    return start->run(start->argument);
}

[[gnu::constructor]] void at_start() {
    if (in("main")) {
        spoil();
    }
}

}  // namespace

extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*),
                              void* argument) {
    static const auto real = reinterpret_cast<decltype(&pthread_create)>(dlsym(RTLD_NEXT, "pthread_create"));
    if (!may_start()) {
        return EAGAIN;
    }
    if (!in("threads")) {
        return real(thread, attributes, run, argument);
    }
    return real(thread, attributes, spoiled, new Start{run, argument});
}
