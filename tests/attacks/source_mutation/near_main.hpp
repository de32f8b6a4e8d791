// What the makers of tables have in common: `make SEED NUMBER` prints rows, `differ FILE` the number of the
// first row of which the verifier says something else.
#pragma once
#include <cstdio>

#include "rooms/verify/core/leaf_rows.hpp"

namespace leaf_rows {

/// `judged` is what the verifier says of the words of a row.
template <class Make, class Judged>
int near_main(int argc, char** argv, const Make& make, const Judged& judged) {
    const std::vector<std::string> words(argv, argv + argc);
    if (words.size() == 4 && words[1] == "make") return make(std::stoull(words[2]), std::stoi(words[3])), 0;
    if (words.size() != 3 || words[1] != "differ") {
        std::fprintf(stderr, "usage: %s make SEED NUMBER | %s differ FILE\n", argv[0], argv[0]);
        return 2;
    }
    std::size_t number = 0;
    for (const Row& row : read(words[2])) {
        if (judged(row.leaf) != row.result) return std::printf("%zu\n", number), 1;
        ++number;
    }
    return 0;
}

}  // namespace leaf_rows
