#include "file/folder_lock.hpp"

#include <optional>

#include "catch.hpp"
#include "programs/cli/process.hpp"

using dumbbell::FolderLock;
using dumbbell_test::TemporaryFolder;

TEST_CASE("one at a time has a folder, and gives it back at the end") {
    const TemporaryFolder folder;
    std::optional<FolderLock> first(std::in_place);
    REQUIRE(first->take(folder.path()));
    FolderLock second;
    CHECK_FALSE(second.take(folder.path()));
    first.reset();
    CHECK(second.take(folder.path()));
}

TEST_CASE("what cannot be opened is not called taken") {
    const TemporaryFolder folder;
    dumbbell_test::write_file(folder / "file", "");
    FolderLock lock;
    CHECK_THROWS_WITH(lock.take(folder / "file"),
                      "cannot open the folder '" + (folder / "file") + "': Not a directory");
    CHECK_THROWS_WITH(lock.take(folder / "missing"),
                      "cannot open the folder '" + (folder / "missing") + "': No such file or directory");
}
