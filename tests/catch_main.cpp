// The main() of every test program, compiled once: version 3 of Catch2 has it in a library.
#define CATCH_CONFIG_MAIN
#include "catch.hpp"
