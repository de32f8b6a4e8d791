// The memory of a BigInterval: that of a thread's own is given back before the thread ends.
#include <flint/flint.h>
#include <gmp.h>
#include <mpfr.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <thread>
#include <vector>

#include "number/big_interval.hpp"

using namespace dumbbell;

namespace {

std::size_t blocks = 0;       ///< of Arb, Flint, MPFR and GMP that have not been given back
std::size_t blocks_ever = 0;  ///< those that have, too

void note_block() {
    ++blocks;
    ++blocks_ever;
}
void* allocate(std::size_t size) {
    note_block();
    return std::malloc(size);
}
void* allocate_zeros(std::size_t count, std::size_t size) {
    note_block();
    return std::calloc(count, size);
}
void* reallocate(void* block, std::size_t size) {
    if (block == nullptr) {
        note_block();
    }
    return std::realloc(block, size);
}
void* reallocate_gmp(void* block, std::size_t /*before*/, std::size_t size) {
    return reallocate(block, size);
}
void release(void* block) {
    blocks -= block == nullptr ? 0 : 1;
    std::free(block);
}
void release_gmp(void* block, std::size_t /*size*/) { release(block); }

/// Blocks that are left over when a thread has ended that worked so, and needed some.
template <class Work>
std::size_t left_by(const Work& work) {
    blocks = blocks_ever = 0;
    __flint_set_memory_functions(allocate, allocate_zeros, reallocate, release);
    mp_set_memory_functions(allocate, reallocate_gmp, release_gmp);
    std::jthread([&] {
        work();
        CHECK(blocks_ever > 0);
        flint_cleanup();
    }).join();
    mp_set_memory_functions(nullptr, nullptr, nullptr);
    __flint_set_memory_functions(std::malloc, std::calloc, std::realloc, std::free);
    return blocks;
}

BigInterval third() { return BigInterval(1, 2) / BigInterval(3); }

}  // namespace

TEST_CASE("A thread gives back the memory of its values") {
    CHECK(left_by([] {
              const PrecisionScope scope(300);
              BigInterval a = third();
              BigInterval b = a;
              b = std::move(a);
              a = b * b;
          }) == 0);
    CHECK(left_by([] {
              const PrecisionScope scope(300);
              const std::vector<BigInterval> many(100, third());  // more than are kept for new ones
          }) == 0);
    CHECK(left_by([] {
              const PrecisionScope scope(64 * 100);  // larger ones, too
              (void)third();
          }) == 0);
    const PrecisionScope scope(300);
    const BigInterval given = third();
    CHECK(left_by([&] { const std::vector<BigInterval> copies(3, given); }) == 0);
}

TEST_CASE("A thread gives back the memory of numbers whose exponents need some") {
    const auto power = [](double x) {
        BigInterval value(x);
        for (int i = 0; i < 70; ++i) {
            value = sqr(value);
        }
        return value;
    };
    CHECK(left_by([&] { (void)power(0.5); }) == 0);
    CHECK(left_by([&] {
              const PrecisionScope scope(300);
              (void)(power(3) * third());
          }) == 0);
    CHECK(left_by([&] {
              const PrecisionScope scope(300);
              (void)sin_cos(power(0.5));
              (void)asin(power(0.5));
          }) == 0);
}

TEST_CASE("A thread gives back the constants that it used") {
    CHECK(left_by([] {
              const PrecisionScope scope(300);
              (void)asin(BigInterval(0.25));
          }) == 0);
    CHECK(left_by([] {
              (void)pi<BigInterval>();  // is there when the first scope begins
              const PrecisionScope scope(300);
              (void)pi<BigInterval>();
          }) == 0);
    CHECK(left_by([] {
              mpfr_t value;
              mpfr_init2(value, 300);
              mpfr_const_pi(value, MPFR_RNDN);
              mpfr_clear(value);
          }) == 0);
}
