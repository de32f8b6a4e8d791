// The libraries on threads on which the program around them changed what arithmetic depends on.
#include <mpfr.h>
#include <pthread.h>

#include <cfenv>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "catch.hpp"
#include "dumbbell/certify.hpp"
#include "dumbbell/error.hpp"
#include "dumbbell/trace.hpp"
#include "dumbbell/verify.hpp"

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

using namespace dumbbell::api;

namespace {

/// What all functions of the libraries say, as text.
std::string all_results() {
    std::string text;
    const auto add = [&](const Interval& x) {
        for (const double end : {x.lo, x.hi}) {
            text.append(reinterpret_cast<const char*>(&end), sizeof end);
        }
    };
    for (const char* ratio : {"10", "4:5", "4.603338848751701"}) {
        text += certify(MassRatio(ratio), {.jobs = 2}).certificate;
    }
    for (const int digits : {0, 30}) {
        for (const Collision& c : trace(MassRatio("10"), {"1/3", "1", "3", "-1/2"}, digits).collisions) {
            add(c.time);
        }
    }
    text += verify(DUMBBELL_CERTIFICATES "/q-10.dbc", {"10", 4, 4}).text;
    text += verify(DUMBBELL_CERTIFICATES "/stairs-1-100.dbc", {"1:100", 10}, 2).text;
    return text;
}

/// Runs on a thread of its own with so much stack, in bytes.
void on_thread(std::size_t stack, const std::function<void()>& work) {
    pthread_attr_t attributes;
    pthread_t thread{};
    REQUIRE(pthread_attr_init(&attributes) == 0);
    REQUIRE(pthread_attr_setstacksize(&attributes, stack) == 0);
    const auto run = [](void* given) -> void* {
        (*static_cast<const std::function<void()>*>(given))();
        return nullptr;
    };
    auto copy = work;
    REQUIRE(pthread_create(&thread, &attributes, run, &copy) == 0);
    REQUIRE(pthread_join(thread, nullptr) == 0);
    REQUIRE(pthread_attr_destroy(&attributes) == 0);
}

struct Spoiled {
    const char* what;
    std::function<void()> spoil;
    std::function<bool()> is_spoiled;
};

std::vector<Spoiled> spoiled_ways() {
    std::vector<Spoiled> ways;
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        ways.push_back(
            {"rounding", [=] { std::fesetround(mode); }, [=] { return std::fegetround() == mode; }});
    }
#if defined(__GLIBC__)
    for (const int traps : {FE_INVALID, FE_DIVBYZERO, FE_OVERFLOW, FE_UNDERFLOW, FE_INEXACT, FE_ALL_EXCEPT}) {
        ways.push_back({"traps", [=] { feenableexcept(traps); }, [=] { return fegetexcept() == traps; }});
    }
#endif
#if defined(__SSE2__)
    for (const unsigned bits : {0x8000U, 0x40U, 0x8040U}) {
        ways.push_back({"flushing", [=] { _mm_setcsr(_mm_getcsr() | bits); },
                        [=] { return (_mm_getcsr() & bits) == bits; }});
    }
#endif
    for (const auto& ends : {std::pair{-148, 128}, std::pair{0, 1}, std::pair{-20, 20}}) {
        ways.push_back({"exponents",
                        [=] {
                            mpfr_set_emin(ends.first);
                            mpfr_set_emax(ends.second);
                        },
                        [=] { return mpfr_get_emin() == ends.first && mpfr_get_emax() == ends.second; }});
    }
    ways.push_back(
        {"precision",
         [] {
             mpfr_set_default_prec(2);
             mpfr_set_default_rounding_mode(MPFR_RNDU);
         },
         [] { return mpfr_get_default_prec() == 2 && mpfr_get_default_rounding_mode() == MPFR_RNDU; }});
    ways.push_back({"raised flags", [] { std::feraiseexcept(FE_DIVBYZERO); },
                    [] { return std::fetestexcept(FE_ALL_EXCEPT) == FE_DIVBYZERO; }});
    return ways;
}

}  // namespace

TEST_CASE(
    "Whatever the caller made of arithmetic, each result is the same, and the caller has its own back") {
    const std::string expected = all_results();
    for (const Spoiled& way : spoiled_ways()) {
        std::string found;
        bool is_kept = false;
        on_thread(8 << 20, [&] {
            std::feclearexcept(FE_ALL_EXCEPT);
            way.spoil();
            found = all_results();
            is_kept = way.is_spoiled();
        });
        CAPTURE(way.what);
        CHECK(found == expected);
        CHECK(is_kept);
    }
}

TEST_CASE("What is refused gives the caller's settings back, too") {
    bool is_kept = false;
    on_thread(8 << 20, [&] {
        std::fesetround(FE_UPWARD);
        try {
            (void)MassRatio("none");
        } catch (const InputError&) {
            is_kept = std::fegetround() == FE_UPWARD;
        }
    });
    CHECK(is_kept);
}

TEST_CASE("A thread of little stack has the same results") {
    const std::string expected = all_results();
    for (const std::size_t stack : {32U << 10, 64U << 10, 128U << 10, 256U << 10}) {
        CAPTURE(stack);
        std::string found;
        bool refused = false;
        on_thread(stack, [&] {
            found = all_results();
            try {
                (void)certify(MassRatio("10"), {.jobs = 0});
            } catch (const InputError&) {
                refused = true;
            }
        });
        CHECK(found == expected);
        CHECK(refused);
    }
}
