#include "audit/audit.hpp"
#include "base/error.hpp"
#include "catch.hpp"

TEST_CASE("built without CGAL, the audit says what it lacks, and claims nothing") {
    CHECK_THROWS_WITH(dumbbell::audit::audit_file(DUMBBELL_STAIRS), Contains("without CGAL"));
}
