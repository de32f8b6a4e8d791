#pragma once

/// What is used of the C library Work Queue, whose headers know nothing of C++.
extern "C" {
#include <cctools/debug.h>
#include <cctools/hash_table.h>
#include <cctools/link.h>
#include <cctools/work_queue.h>
}
// Its names of everyday words.
#undef debug
#undef fatal
#undef notice
#undef warn

/// A connection; `link` alone is the system's function.
using Link = struct link;
