#pragma once

#include <unistd.h>

#include <cstdlib>

#include "catch.hpp"

namespace dumbbell_test {

// Root may read and write everything: so somebody else, for a while.
class NotRoot {
  public:
    NotRoot() : was_root_(::geteuid() == 0) { REQUIRE((!was_root_ || ::seteuid(65534) == 0)); }
    ~NotRoot() {
        if (was_root_ && ::seteuid(0) != 0) {
            std::abort();
        }
    }
    NotRoot(const NotRoot&) = delete;
    NotRoot& operator=(const NotRoot&) = delete;

  private:
    bool was_root_;
};

}  // namespace dumbbell_test
