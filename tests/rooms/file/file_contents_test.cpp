#include "file/file_contents.hpp"

#include <sys/stat.h>

#include "base/error.hpp"
#include "catch.hpp"
#include "programs/cli/process.hpp"
#include "rooms/not_root.hpp"

using namespace dumbbell_test;
using dumbbell::file_contents;
using dumbbell::InputError;

namespace {

void cannot_be_read(const std::string& path, const std::string& why) {
    CHECK_THROWS_MATCHES(file_contents(path), InputError, Message("cannot read '" + path + "': " + why));
}

}  // namespace

TEST_CASE("a file is read whole, however long") {
    const TemporaryFolder folder;
    for (const std::size_t length : {0, 1, 65535, 65536, 200'000}) {
        const std::string bytes = std::string(length / 2, '\0') + std::string(length - length / 2, 'x');
        write_file(folder / "file", bytes);
        CHECK(file_contents(folder / "file") == bytes);
    }
}

TEST_CASE("what cannot be read is named, with the reason") {
    const TemporaryFolder folder;
    cannot_be_read(folder / "missing", "no such file");
    cannot_be_read(folder.path(), "it is a directory");
    cannot_be_read(folder / std::string(300, 'x'), "File name too long");
    cannot_be_read("/proc/self/mem", "Input/output error");  // it opens
    std::filesystem::create_symlink("loop", folder / "loop");
    cannot_be_read(folder / "loop", "Too many levels of symbolic links");
    REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);  // nobody writes to it
    cannot_be_read(folder / "pipe", "not a regular file");
}

TEST_CASE("a file or a folder of somebody else is not called missing or empty") {
    const TemporaryFolder folder;
    write_file(folder / "file", "text");
    ::chmod((folder / "file").c_str(), 0);
    ::chmod(folder.path().c_str(), 0755);
    {
        const NotRoot user;
        cannot_be_read(folder / "file", "Permission denied");
    }
    ::chmod(folder.path().c_str(), 0);
    {
        const NotRoot user;
        cannot_be_read(folder / "file", "Permission denied");
    }
    ::chmod(folder.path().c_str(), 0755);
}
