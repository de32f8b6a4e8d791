#pragma once

// Catch2, the framework of the tests, of version 2 or 3: their headers differ, and so does the name of what
// says that a text contains another. No other file includes Catch2's headers or names its namespace.
#if __has_include(<catch2/catch_test_macros.hpp>)

#include <catch2/catch_approx.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <string>

using Catch::Approx;

inline auto Contains(const std::string& part) { return Catch::Matchers::ContainsSubstring(part); }

#else

#include <catch2/catch.hpp>

using Catch::Matchers::Contains;

#endif

using Catch::Matchers::EndsWith;
using Catch::Matchers::Message;
using Catch::Matchers::StartsWith;
