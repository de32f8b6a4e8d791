#include "dumbbell/version.hpp"

#include <string>

#include "catch.hpp"

namespace api = dumbbell::api;

TEST_CASE("The version is the project's") {
    CHECK(api::version == DUMBBELL_PROJECT_VERSION);
    CHECK(api::version == std::to_string(api::version_major) + "." + std::to_string(api::version_minor) +
                              "." + std::to_string(api::version_patch));
}
