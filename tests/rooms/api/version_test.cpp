#include "dumbbell/version.hpp"

#include <catch2/catch.hpp>
#include <string>

namespace api = dumbbell::api;

TEST_CASE("The version is the project's") {
    CHECK(api::version == DUMBBELL_PROJECT_VERSION);
    CHECK(api::version == std::to_string(api::version_major) + "." + std::to_string(api::version_minor) +
                              "." + std::to_string(api::version_patch));
}
