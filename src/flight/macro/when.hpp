#pragma once

/// When an orbit is long: from how many collisions on macro steps (L42) pay, for each who asks.
namespace dumbbell::flight::macro {

/// With fewer collisions, and in multiple precision, a macro step ends too early to pay.
inline constexpr long least_with_few_bits = 10'000;

/// From here on the orbit that decides a critical ratio is followed by macro steps, which is faster than the
/// interval Newton step of critical/enclose.cpp: that takes 0.36 s for n = 20,000 to 15 digits, this 0.18 s
/// for the next one, and 0.34 s for n = 10^12.
inline constexpr long first_long = 20'001;
[[nodiscard]] constexpr bool is_long(long n) { return n >= first_long; }

/// In double, steps over few collisions mostly fail, and cost milliseconds each: with 20,000 in place of
/// 40,000 `certify 2.5e9:2.501e9 --gap 1e-9` takes 15 s in place of 3.5 s.
inline constexpr long least_in_double = 40'000;

/// From here on the steps of a range are placed by macro steps. Flight by flight the four steps of
/// 1e12:1.00001e12 took 43 s; so all of `certify` takes 1.2 s.
inline constexpr long least_for_placing = 100'000;

}  // namespace dumbbell::flight::macro
