#include "campaign/password.hpp"

#include <sys/stat.h>

#include <catch2/catch.hpp>

#include "base/error.hpp"
#include "programs/cli/process.hpp"

using namespace dumbbell_test;
using Catch::Matchers::Contains;
using dumbbell::InputError;
using dumbbell::campaign::password_file;
using dumbbell::campaign::read_password;

TEST_CASE("a new password is random, hexadecimal, and its owner's alone") {
    const TemporaryFolder folder;
    const TemporaryFolder other;
    const std::string file = password_file(folder.path());
    CHECK(file == folder / "password");
    CHECK(folder.names() == std::vector<std::string>{"password"});
    CHECK((std::filesystem::status(file).permissions() & std::filesystem::perms::mask) ==
          (std::filesystem::perms::owner_read | std::filesystem::perms::owner_write));
    const std::string line = contents(file);
    REQUIRE(line.size() == 65);
    CHECK(line.find_first_not_of("0123456789abcdef") == 64);
    CHECK(line.back() == '\n');
    CHECK(read_password(file) == line);
    CHECK(contents(password_file(other.path())) != line);
}

TEST_CASE("a password that is there stays, and what a killed program left is cleared away") {
    const TemporaryFolder folder;
    write_file(folder / "password.dumbbell-tmp", "half");
    const std::string first = contents(password_file(folder.path()));
    CHECK(contents(password_file(folder.path())) == first);
    CHECK(folder.names() == std::vector<std::string>{"password"});
}

TEST_CASE("a password that others can read is refused, with what to type") {
    const TemporaryFolder folder;
    const std::string file = password_file(folder.path());
    const std::string line = contents(file);
    for (const mode_t mode : {0640, 0604, 0620, 0601}) {
        ::chmod(file.c_str(), mode);
        CHECK_THROWS_WITH(read_password(file), Contains("chmod 600 '" + file + "'"));
        CHECK_THROWS_AS(password_file(folder.path()), InputError);
    }
    CHECK(contents(file) == line);
}

TEST_CASE("what is no password is refused, and left as it is") {
    const TemporaryFolder folder;
    const std::string file = folder / "password";
    for (const std::string& text :
         {std::string(), std::string("\n"), std::string("fifteen letters"), std::string(257, 'x'),
          std::string(40, 'x') + "\nsecond line\n", std::string(40, '\0'), std::string(40, 'x') + "\n\n"}) {
        write_file(file, text);
        ::chmod(file.c_str(), 0600);
        CHECK_THROWS_WITH(password_file(folder.path()), Contains("holds no password"));
        CHECK(contents(file) == text);
    }
    write_file(file, std::string(256, 'x') + "\n");
    CHECK(read_password(file).size() == 257);
    write_file(file, std::string(16, 'x'));
    CHECK(read_password(file).size() == 16);
}

TEST_CASE("a password file that cannot be read or made is named") {
    const TemporaryFolder folder;
    CHECK_THROWS_WITH(read_password(folder / "none"), Contains(folder / "none") && Contains("No such file"));
    CHECK_THROWS_WITH(read_password(folder.path()), Contains("is not a regular file"));
    CHECK_THROWS_WITH(password_file(folder / "none"), Contains(folder / "none/password"));
    REQUIRE(::mkfifo((folder / "password").c_str(), 0600) == 0);
    CHECK_THROWS_WITH(password_file(folder.path()), Contains("is not a regular file"));
}
