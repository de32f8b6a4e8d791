#include "file/folder_lock.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <optional>
#include <thread>

#include "programs/cli/process.hpp"

using dumbbell::FolderLock;
using dumbbell_test::TemporaryFolder;

TEST_CASE("one at a time has a folder, and gives it back at the end") {
    const TemporaryFolder folder;
    CHECK_FALSE(FolderLock::is_taken(folder.path()));
    std::optional<FolderLock> first(std::in_place);
    REQUIRE(first->take(folder.path()));
    CHECK(FolderLock::is_taken(folder.path()));
    FolderLock second;
    CHECK_FALSE(second.take(folder.path()));
    first.reset();
    CHECK_FALSE(FolderLock::is_taken(folder.path()));
    CHECK(second.take(folder.path()));
}

TEST_CASE("a program that asks whether a folder is taken does not take it") {
    const TemporaryFolder folder;
    FolderLock lock;
    CHECK_FALSE(FolderLock::is_taken(folder.path()));
    CHECK(lock.take(folder.path()));
}

TEST_CASE("a program that has a folder for a moment only is waited for") {
    const TemporaryFolder folder;
    for (bool taken = false; !taken;) {  // on a busy machine the moment may last too long
        std::optional<FolderLock> first(std::in_place);
        REQUIRE(first->take(folder.path()));
        std::jthread soon([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            first.reset();
        });
        FolderLock second;
        taken = second.take(folder.path());
    }
}

TEST_CASE("what cannot be opened is not called taken") {
    const TemporaryFolder folder;
    dumbbell_test::write_file(folder / "file", "");
    FolderLock lock;
    CHECK_THROWS_WITH(lock.take(folder / "file"),
                      "cannot open the folder '" + (folder / "file") + "': Not a directory");
    CHECK_THROWS_WITH(lock.take(folder / "missing"),
                      "cannot open the folder '" + (folder / "missing") + "': No such file or directory");
    CHECK_FALSE(FolderLock::is_taken(folder / "missing"));
}
