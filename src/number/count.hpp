#pragma once

#include <fmt/core.h>

#include <compare>
#include <concepts>
#include <cstdint>
#include <iosfwd>
#include <limits>
#include <string>
#include <utility>

#include "number/integer.hpp"

namespace dumbbell {

/// A number of collisions, of any size, in eight bytes: trees have two at every leaf, nearly all of them
/// small, which take no memory of their own.
class Count {
  public:
    Count() = default;
    template <std::integral T>
    Count(T value)  // NOLINT(google-explicit-constructor): no value is lost
        : word_(std::in_range<long>(value) && fits(static_cast<long>(value))
                    ? tagged(static_cast<long>(value))
                    : address_of_new(Integer(value))) {}
    explicit Count(Integer value);
    /// Towards zero. Precondition: it is finite.
    explicit Count(double value);
    Count(const Count& other) : word_(other.is_small() ? other.word_ : address_of_new(*other.large())) {}
    Count(Count&& other) noexcept : word_(std::exchange(other.word_, tagged(0))) {}
    Count& operator=(const Count& other) { return *this = Count(other); }
    Count& operator=(Count&& other) noexcept {
        std::swap(word_, other.word_);
        return *this;
    }
    ~Count() {
        if (!is_small()) {
            free_large();
        }
    }

    explicit operator double() const;
    [[nodiscard]] Integer integer() const { return is_small() ? Integer(small()) : *large(); }
    [[nodiscard]] std::string str() const { return is_small() ? std::to_string(small()) : large()->str(); }

    Count& operator+=(const Count& y) {
        return *this = both_small(y) ? Count(small() + y.small()) : Count(integer() + y.integer());
    }
    Count& operator-=(const Count& y) {
        return *this = both_small(y) ? Count(small() - y.small()) : Count(integer() - y.integer());
    }
    Count& operator++() { return *this += 1; }
    Count& operator--() { return *this -= 1; }

    friend Count operator+(Count x, const Count& y) { return x += y; }
    friend Count operator-(Count x, const Count& y) { return x -= y; }
    /// Precondition: x >= 0, y > 0.
    friend long operator%(const Count& x, long y) {
        return x.is_small() ? x.small() % y : (*x.large() % Integer(y)).convert_to<long>();
    }
    friend bool operator==(const Count& x, const Count& y) { return (x <=> y) == 0; }
    friend std::strong_ordering operator<=>(const Count& x, const Count& y) {
        return x.both_small(y) ? x.small() <=> y.small() : x.integer() <=> y.integer();
    }
    friend long as_long(const Count& n);
    friend std::ostream& operator<<(std::ostream& out, const Count& x);

  private:
    /// With the tag's bit beside it.
    static constexpr bool fits(long value) {
        constexpr long half = std::numeric_limits<long>::max() / 2;
        return -half <= value && value <= half;
    }
    static constexpr std::intptr_t tagged(long value) { return 2 * value + 1; }
    static std::intptr_t address_of_new(Integer value);
    void free_large() const;

    [[nodiscard]] bool is_small() const { return (word_ & 1) != 0; }
    [[nodiscard]] bool both_small(const Count& other) const { return (word_ & other.word_ & 1) != 0; }
    [[nodiscard]] long small() const { return word_ >> 1; }
    [[nodiscard]] const Integer* large() const {
        return reinterpret_cast<const Integer*>(word_);  // NOLINT(*-reinterpret-cast,*-no-int-to-ptr)
    }

    std::intptr_t word_ =
        tagged(0);  ///< 2 v + 1 for a value v that fits, else the (even) address of an Integer
};

/// Where only counts are meant that are followed one by one, listed or drawn. Throws InputError if it does
/// not fit.
[[nodiscard]] long as_long(const Count& n);

}  // namespace dumbbell

namespace fmt {

template <>
struct formatter<dumbbell::Count> : formatter<string_view> {
    format_context::iterator format(const dumbbell::Count& x, format_context& context) const;
};

}  // namespace fmt
