#include "file/atomic_file.hpp"

#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <zlib.h>

#include <array>
#include <atomic>
#include <csignal>
#include <thread>

#include "base/error.hpp"
#include "catch.hpp"
#include "programs/cli/process.hpp"
#include "rooms/not_root.hpp"

using namespace dumbbell_test;
using dumbbell::AtomicFile;
using dumbbell::InputError;
using dumbbell::output_target;

namespace {

using Names = std::vector<std::string>;

std::string unpacked(const std::string& path) {
    gzFile file = gzopen(path.c_str(), "rb");
    std::array<char, 65536> buffer{};
    std::string text;
    for (int n = 0; (n = gzread(file, buffer.data(), buffer.size())) > 0;) {
        text.append(buffer.data(), static_cast<std::size_t>(n));
    }
    gzclose(file);
    return text;
}

// No file of this process may grow beyond `bytes`: what a full disk looks like to it.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limited{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limited);
    }
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

  private:
    rlimit before_{};
    void (*handler_)(int);
};

// A file system of 64 kB; only root can have one.
class SmallDisk {
  public:
    explicit SmallDisk(std::string path) : path_(std::move(path)) {
        std::filesystem::create_directory(path_);
        mounted_ = ::mount("tmpfs", path_.c_str(), "tmpfs", 0, "size=64k") == 0;
    }
    ~SmallDisk() {
        if (mounted_) {
            ::umount(path_.c_str());
        }
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

    [[nodiscard]] bool mounted() const { return mounted_; }

  private:
    std::string path_;
    bool mounted_;
};

}  // namespace

TEST_CASE("an empty file and one of ten megabytes can be committed") {
    const TemporaryFolder folder;
    AtomicFile(folder / "empty").commit("");
    CHECK(contents(folder / "empty").empty());
    const std::string big(10'000'000, 'x');
    AtomicFile(folder / "big").commit(big);
    CHECK(contents(folder / "big") == big);
}

TEST_CASE("what a program left that was killed while it wrote is taken over") {
    const TemporaryFolder folder;
    for (const char* text : {"", "one", "longer than what was left"}) {
        write_file(dumbbell::temporary_name(folder / "file"), "half of something");
        AtomicFile(folder / "file").commit(text);
        CHECK(contents(folder / "file") == text);
        CHECK(folder.names() == Names{"file"});
    }
}

TEST_CASE("what a killed program left is not written into: it may have another name") {
    const TemporaryFolder folder;
    write_file(folder / "mine", "mine");
    std::filesystem::create_hard_link(folder / "mine", dumbbell::temporary_name(folder / "file"));
    AtomicFile(folder / "file").commit("new");
    CHECK(contents(folder / "mine") == "mine");
    CHECK(folder.names() == Names{"file", "mine"});
}

TEST_CASE(
    "a file keeps its access rights, whatever was left under the temporary name, and a link is replaced") {
    const TemporaryFolder folder;
    const auto mode = [](const std::string& file) {
        struct stat status {};
        REQUIRE(::lstat(file.c_str(), &status) == 0);
        return status.st_mode;
    };
    for (const mode_t rights : {0600U, 0644U, 0666U}) {
        write_file(folder / "file", "old");
        write_file(dumbbell::temporary_name(folder / "file"), "half");
        ::chmod((folder / "file").c_str(), rights);
        AtomicFile(folder / "file").commit("new");
        CHECK(mode(folder / "file") == (S_IFREG | rights));
        std::filesystem::remove(folder / "file");
    }
    const mode_t before = ::umask(027);
    AtomicFile(folder / "file").commit("new");
    ::umask(before);
    CHECK(mode(folder / "file") == (S_IFREG | 0640U));
    std::filesystem::create_symlink("file", folder / "link");
    AtomicFile(folder / "link").commit("in its place");
    CHECK(S_ISREG(mode(folder / "link")));
    CHECK(contents(folder / "file") == "new");
}

TEST_CASE("a name given by a user is kept where no link is in the way, and leads to no device") {
    const TemporaryFolder folder;
    CHECK(output_target(folder / "none/file") == folder / "none/file");
    CHECK(output_target("file") == "file");
    CHECK(output_target("/dev/shm/file") == "/dev/shm/file");
    CHECK_THROWS_WITH(output_target("/dev/shm/../x"), Contains("below /"));
}

TEST_CASE("a link that waits under the temporary name is not followed") {
    const TemporaryFolder folder;
    write_file(folder / "mine", "mine");
    std::filesystem::create_symlink("mine", dumbbell::temporary_name(folder / "file"));
    CHECK_THROWS_AS(AtomicFile(folder / "file"), InputError);
    CHECK(contents(folder / "mine") == "mine");
}

TEST_CASE("what is under the temporary name and cannot be removed is told") {
    const TemporaryFolder folder;
    std::filesystem::create_directory(dumbbell::temporary_name(folder / "file"));
    CHECK_THROWS_AS(AtomicFile(folder / "file"), InputError);
}

TEST_CASE("who writes the same file at the same time waits: one of them is there in the end, whole") {
    const TemporaryFolder folder;
    const auto text = [](int writer) { return std::string(200'000, static_cast<char>('a' + writer)); };
    std::atomic<int> failures = 0;
    {
        std::vector<std::jthread> writers;
        for (int writer = 0; writer < 4; ++writer) {
            writers.emplace_back([&, writer] {
                for (int i = 0; i < 25; ++i) {
                    try {
                        AtomicFile(folder / "file").commit(text(writer));
                    } catch (const InputError&) {
                        ++failures;
                    }
                }
            });
        }
    }
    CHECK(failures == 0);
    const std::string last = contents(folder / "file");
    CHECK(last == text(last.front() - 'a'));
    CHECK(folder.names() == Names{"file"});
}

TEST_CASE("without a commit the old file stays, with one it is replaced as a whole") {
    const TemporaryFolder folder;
    write_file(folder / "file", "old");
    {
        const AtomicFile file(folder / "file");
        CHECK(folder.names() == Names{"file"});  // nothing that a killed program could leave
    }
    CHECK(contents(folder / "file") == "old");

    std::ifstream reader(folder / "file");  // someone who reads the old file goes on reading it
    AtomicFile(folder / "file").commit("new and longer");
    CHECK(std::string(std::istreambuf_iterator<char>(reader), {}) == "old");
    CHECK(contents(folder / "file") == "new and longer");
    CHECK(folder.names() == Names{"file"});
}

TEST_CASE("a name that ends in .gz is compressed, reproducibly: no time and no name inside") {
    const TemporaryFolder folder;
    const std::string text(100'000, 'd');
    AtomicFile(folder / "one.gz").commit(text);
    AtomicFile(folder / "two.gz").commit(text);
    const std::string bytes = contents(folder / "one.gz");
    CHECK(bytes.size() < 1000);
    CHECK(bytes.substr(0, 3) == "\x1f\x8b\x08");
    CHECK(bytes.substr(3, 5) == std::string(5, '\0'));  // no name, no time
    CHECK(bytes == contents(folder / "two.gz"));
    CHECK(unpacked(folder / "one.gz") == text);
}

TEST_CASE("a text that comes in parts makes the same file as one that comes at once, compressed too") {
    const TemporaryFolder folder;
    std::vector<std::string> lines;
    std::string text;
    for (int i = 0; i < 50'000; ++i) {
        text += lines.emplace_back("exactly " + std::to_string(i % 977) + "\n");
    }
    for (const char* name : {"file", "file.gz"}) {
        AtomicFile(folder / name).commit(text);
        const std::string at_once = contents(folder / name);
        AtomicFile(folder / name).commit([&](const dumbbell::Sink& sink) {
            for (const std::string& line : lines) {
                sink(line);
            }
        });
        CHECK((contents(folder / name) == at_once));
    }
    CHECK((unpacked(folder / "file.gz") == text));
}

TEST_CASE("a text that is not completed leaves the old file, and nothing else") {
    const TemporaryFolder folder;
    write_file(folder / "file", "old");
    CHECK_THROWS_WITH(AtomicFile(folder / "file").commit([](const dumbbell::Sink& sink) {
        sink("half");
        throw InputError("no more");
    }),
                      Contains("no more"));
    CHECK(contents(folder / "file") == "old");
    CHECK(folder.names() == Names{"file"});
}

TEST_CASE("a place that cannot be written is known before any work is done") {
    const TemporaryFolder folder;
    CHECK_THROWS_AS(AtomicFile(folder / "no such folder/file"), InputError);
    CHECK_THROWS_WITH(AtomicFile(folder / "no such folder/file"),
                      Contains("there is no folder '" + folder / "no such folder" + "'"));
    CHECK_THROWS_AS(AtomicFile("/proc/dumbbell-test"), InputError);
    CHECK_THROWS_AS(AtomicFile(folder / std::string(300, 'x')), InputError);
    write_file(folder / "file", "");
    CHECK_THROWS_AS(AtomicFile(folder / "file/file"), InputError);
    CHECK(folder.names() == Names{"file"});
}

TEST_CASE("a read-only folder is refused") {
    const TemporaryFolder folder;
    ::chmod(folder.path().c_str(), 0555);
    {
        const NotRoot user;
        CHECK_THROWS_AS(AtomicFile(folder / "file"), InputError);
    }
    ::chmod(folder.path().c_str(), 0755);
}

TEST_CASE("a directory is never replaced") {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "sub");
    CHECK_THROWS_WITH(AtomicFile(folder / "sub"), Contains("directory"));
    CHECK(folder.names() == Names{"sub"});
}

TEST_CASE("what is no regular file, like a pipe or /dev/null, is never replaced") {
    const TemporaryFolder folder;
    REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
    CHECK_THROWS_AS(AtomicFile(folder / "pipe"), InputError);
    CHECK(std::filesystem::is_fifo(folder / "pipe"));
    CHECK(folder.names() == Names{"pipe"});
}

TEST_CASE("a file that does not fit leaves the old one and no other") {
    const TemporaryFolder folder;
    write_file(folder / "file", "old");
    {
        const FileSizeLimit limit(65536);
        CHECK_THROWS_AS(AtomicFile(folder / "file").commit(std::string(1'000'000, 'x')), InputError);
        CHECK_THROWS_WITH(AtomicFile(folder / "new").commit(std::string(1'000'000, 'x')), Contains("write"));
    }
    CHECK(contents(folder / "file") == "old");
    CHECK(folder.names() == Names{"file"});
}

TEST_CASE("a full disk leaves nothing under the final name (needs the right to mount one)") {
    const TemporaryFolder folder;
    const SmallDisk disk(folder / "disk");
    if (!disk.mounted()) {
        WARN("skipped: only root can mount a small disk");
        return;
    }
    const std::string path = folder / "disk/file";
    CHECK_THROWS_WITH(AtomicFile(path).commit(std::string(1'000'000, 'x')), Contains("No space left"));
    CHECK(std::filesystem::is_empty(folder / "disk"));
    AtomicFile(path).commit("fits");
    CHECK(contents(path) == "fits");
}
