#pragma once

#include <version>

/// How the standard library that a program is compiled with lays out its types, as the name of a namespace
/// around all that a library of dumbbell exports: a program that is compiled otherwise than the library does
/// not link.
#if defined(_LIBCPP_VERSION)
#define DUMBBELL_ABI libcxx
#elif defined(_GLIBCXX_DEBUG) && defined(_GLIBCXX_USE_CXX11_ABI) && !_GLIBCXX_USE_CXX11_ABI
#define DUMBBELL_ABI glibcxx_debug_old_strings
#elif defined(_GLIBCXX_DEBUG)
#define DUMBBELL_ABI glibcxx_debug
#elif defined(_GLIBCXX_USE_CXX11_ABI) && !_GLIBCXX_USE_CXX11_ABI
#define DUMBBELL_ABI old_strings
#else
#define DUMBBELL_ABI usual
#endif
