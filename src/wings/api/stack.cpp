#include "api/stack.hpp"

#include <pthread.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <system_error>

namespace dumbbell::api {
namespace {

/// What is called takes up to 128 KiB; GMP alone up to 64 KiB at a time.
constexpr std::size_t needed = 256 << 10, own_stack = 1 << 20;

/// The stack of a thread as its library knows it; empty where that cannot be asked.
struct Stack {
    std::uintptr_t low = 0, high = 0;

    static Stack of_this_thread() {
        Stack stack;
#if defined(__linux__)
        pthread_attr_t attributes;
        void* low = nullptr;
        std::size_t size = 0;
        if (::pthread_getattr_np(::pthread_self(), &attributes) == 0) {
            if (::pthread_attr_getstack(&attributes, &low, &size) == 0) {
                stack = {reinterpret_cast<std::uintptr_t>(low), reinterpret_cast<std::uintptr_t>(low) + size};
            }
            ::pthread_attr_destroy(&attributes);
        }
#endif
        return stack;
    }
};

/// False also on a stack that is not the thread's own, such as a coroutine's: it is as likely to be small.
bool has_enough() {
    thread_local const Stack stack = Stack::of_this_thread();
    const auto here = reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0));
    return stack.high == 0 || (stack.low < here && here <= stack.high && here - stack.low >= needed);
}

/// What is to be done when the thread ends; made before all else of the thread, it goes last.
struct ThreadEnd {
    void (*call)() = nullptr;
    ~ThreadEnd() {
        if (call != nullptr) {
            call();
        }
    }
};
void at_end_of_thread(void (*call)()) {
    thread_local ThreadEnd end;
    end.call = call;
}

struct Apart {
    const std::function<void()>& work;
    void (*at_end)();
    std::exception_ptr failure;

    static void* run(void* given) {
        auto& self = *static_cast<Apart*>(given);
        at_end_of_thread(self.at_end);
        try {
            self.work();
        } catch (...) {
            self.failure = std::current_exception();
        }
        return nullptr;
    }
};

}  // namespace

void with_stack(const std::function<void()>& work, void (*at_end)()) {
    if (has_enough()) {
        at_end_of_thread(at_end);
        return work();
    }
    Apart apart{work, at_end, nullptr};
    pthread_attr_t attributes;
    pthread_t thread{};
    ::pthread_attr_init(&attributes);
    ::pthread_attr_setstacksize(&attributes, own_stack);
    const int error = ::pthread_create(&thread, &attributes, &Apart::run, &apart);
    ::pthread_attr_destroy(&attributes);
    if (error != 0) {
        throw std::system_error(error, std::generic_category(), "a thread with more stack than this one");
    }
    ::pthread_join(thread, nullptr);
    if (apart.failure) {
        std::rethrow_exception(apart.failure);
    }
}

}  // namespace dumbbell::api
