// Files about initial conditions for tests: one that `dumbbell trace --subdivide` wrote.
#pragma once
#include "rooms/verify/core/make_certificate.hpp"

namespace make {

inline std::string initial_header(const std::string& ratio, const std::string& phi, const std::string& phidot,
                                  const std::string& y, const std::string& ydot) {
    return "dumbbell-certificate 1\ngenerator test 1.0\nlemmas 1\nscene dumbbell\nsection none\n"
           "claim initial-conditions\nratio " +
           ratio + "\nphi " + phi + "\nphidot " + phidot + "\ny " + y + "\nydot " + ydot + "\nbits 53\n";
}

/// phi in [-1, 1], phidot = 1/100, y = 3/2, ydot = -1 at q = 10: all kinds of leaves but `open`.
inline const std::string& falling() {
    static const std::string text = closed(
        initial_header("10/1 10/1", "-1/1 1/1", "1/100 1/100", "3/2 3/2", "-1/1 -1/1") +
        "between 1 5\nsplit phi\nsplit phi\nsplit phi\nsplit phi\nsplit phi\n"
        "between 1 5 light 189b-8 395b-9\nbetween 1 5 light 197b-8 207b-8\nsplit phi\n"
        "between 1 5 light 413b-9 433b-9\nexactly 2 light 27b-5 227b-8\nexactly 2 light 113b-7 69b-6\n"
        "split phi\nexactly 2 light 137b-7 165b-7\nsplit phi\nexactly 2 light 329b-8 359b-8\nbetween 1 5\n"
        "split phi\nsplit phi\nexactly 2 heavy 1511b-10 1535b-10\nsplit phi\n"
        "exactly 2 heavy 3001b-11 189b-7\nbetween 1 2 heavy 745b-9 1501b-10\n"
        "exactly 1 heavy 91b-6 373b-8\n");
    return text;
}

}  // namespace make
