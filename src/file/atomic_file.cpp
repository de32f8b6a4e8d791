#include "file/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "file/descriptor.hpp"

namespace dumbbell {
namespace {

/// One gzip member without time or name, so that the bytes depend on nothing but the contents.
class Gzip {
  public:
    explicit Gzip(const Sink& packed) : packed_(packed) {
        require(
            deflateInit2(&stream_, Z_BEST_COMPRESSION, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) == Z_OK,
            "zlib failed");
    }
    ~Gzip() { deflateEnd(&stream_); }
    Gzip(const Gzip&) = delete;
    Gzip& operator=(const Gzip&) = delete;

    void add(std::string_view part) { deflate_all(std::string(part), Z_NO_FLUSH); }
    void end() { deflate_all("", Z_FINISH); }

  private:
    void deflate_all(std::string part, int flush) {
        stream_.next_in = reinterpret_cast<Bytef*>(part.data());
        stream_.avail_in = static_cast<uInt>(part.size());
        do {
            stream_.next_out = block_.data();
            stream_.avail_out = static_cast<uInt>(block_.size());
            require(deflate(&stream_, flush) != Z_STREAM_ERROR, "zlib failed");
            packed_({reinterpret_cast<const char*>(block_.data()), block_.size() - stream_.avail_out});
        } while (stream_.avail_out == 0);
    }

    const Sink& packed_;
    z_stream stream_{};
    std::vector<Bytef> block_ = std::vector<Bytef>(1U << 16U);
};

[[noreturn]] void fail(const char* doing, const std::string& path) {
    throw InputError(fmt::format("cannot {} '{}': {}; what was under that name before is unchanged", doing,
                                 path, std::strerror(errno)));
}

/// Nothing was begun: names what is missing, if it is the folder.
[[noreturn]] void cannot_create(const std::string& path) {
    const int cause = errno;
    const std::string folder = std::filesystem::path(path).parent_path().string();
    const bool no_folder = cause == ENOENT || cause == ENOTDIR;
    throw InputError(fmt::format("cannot create '{}': {}", path,
                                 no_folder && !folder.empty() ? fmt::format("there is no folder '{}'", folder)
                                                              : std::strerror(cause)));
}

/// A rename would replace whatever stands there, a device like /dev/null too.
void require_place_for_file(const std::string& path) {
    std::error_code unreadable;
    const auto target = std::filesystem::status(path, unreadable);
    if (std::filesystem::is_directory(target)) {
        throw InputError(fmt::format("cannot write '{}': it is a directory; give a file name", path));
    }
    if (!std::filesystem::exists(target)) {
        return;
    }
    if (!std::filesystem::is_regular_file(target)) {
        throw InputError(fmt::format("cannot write '{}': it is not a regular file; give a file name", path));
    }
    // A rename asks for no right to write to what it replaces.
    constexpr auto may_write = std::filesystem::perms::owner_write | std::filesystem::perms::group_write |
                               std::filesystem::perms::others_write;
    if ((target.permissions() & may_write) == std::filesystem::perms::none) {
        throw InputError(
            fmt::format("cannot write '{}': it is read-only; give another name, or make it writable", path));
    }
}

/// The temporary file of a path, made here and locked, so that it is nobody else's; removed at the end unless
/// it was given its final name.
class Temporary {
  public:
    explicit Temporary(const std::string& path) : path_(path), name_(temporary_name(path)) {
        while (!made()) {
        }
    }
    ~Temporary() {
        if (!name_.empty()) {
            ::unlink(name_.c_str());
        }
    }
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;

    void write(std::string_view bytes) const {
        for (std::size_t done = 0; done < bytes.size();) {
            const ssize_t n = ::write(file_.get(), bytes.data() + done, bytes.size() - done);
            if (n < 0 && errno == EINTR) {
                continue;
            }
            if (n <= 0) {
                fail("write", path_);
            }
            done += static_cast<std::size_t>(n);
        }
    }

    /// The owner, as far as this program may, and the access rights of the file that it is to replace.
    void inherit() const {
        if (const auto replaced = regular_file(path_)) {
            (void)!::fchown(file_.get(), replaced->st_uid, replaced->st_gid);
            if (::fchmod(file_.get(), replaced->st_mode & 0777U) != 0) {
                fail("write", path_);
            }
        }
    }

    void sync() const {
        if (::fsync(file_.get()) != 0) {
            fail("sync", path_);
        }
    }

    void give_final_name() {
        if (::rename(name_.c_str(), path_.c_str()) != 0) {
            fail("rename to", path_);
        }
        name_.clear();
    }

  private:
    static std::optional<struct stat> regular_file(const std::string& path) {
        struct stat there {};
        return ::lstat(path.c_str(), &there) == 0 && S_ISREG(there.st_mode) ? std::optional(there)
                                                                            : std::nullopt;
    }

    /// False if the name is to be tried again: what a killed program left is out of the way now, or somebody
    /// else's has its final name.
    bool made() {
        // What is to be replaced may be secret, until it has its rights.
        const mode_t rights = regular_file(path_) ? 0600 : 0666;
        file_ = Descriptor(::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, rights));
        const bool is_new = file_.get() >= 0;
        if (!is_new && errno == EEXIST) {
            file_ = Descriptor(::open(name_.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
            if (file_.get() < 0 && errno == ENOENT) {
                return false;
            }
        }
        if (file_.get() < 0) {
            cannot_create(path_);
        }
        while (::flock(file_.get(), LOCK_EX) != 0) {
            if (errno != EINTR) {
                fail("lock", path_);
            }
        }
        struct stat mine {};
        struct stat named {};
        const bool has_name = ::fstat(file_.get(), &mine) == 0 && ::lstat(name_.c_str(), &named) == 0 &&
                              mine.st_dev == named.st_dev && mine.st_ino == named.st_ino;
        if (is_new && has_name) {
            return true;
        }
        // Removed under the lock: who made it and waits for the lock would take it for its own.
        if (has_name && ::unlink(name_.c_str()) != 0 && errno != ENOENT) {
            cannot_create(path_);
        }
        return false;
    }

    const std::string& path_;
    std::string name_;
    Descriptor file_;
};

/// A new name is durable once its folder is synced; if that cannot be done the file is still complete.
void sync_folder_of(const std::string& path) {
    const auto parent = std::filesystem::path(path).parent_path();
    const Descriptor folder(
        ::open(parent.empty() ? "." : parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    ::fsync(folder.get());
}

}  // namespace

std::string temporary_name(const std::string& path) { return path + ".dumbbell-tmp"; }

std::string output_target(const std::string& name) {
    namespace fs = std::filesystem;
    constexpr int most_links = 40;  // as the kernel follows
    fs::path target = name;
    for (int links = 0;; ++links) {
        std::error_code failed;
        const fs::path folder = fs::weakly_canonical(fs::absolute(target).parent_path(), failed);
        for (const char* system : {"/dev", "/proc"}) {
            const auto below = folder.lexically_relative(system);
            if (!below.empty() && *below.begin() != ".." && *below.begin() != "shm") {
                throw InputError(fmt::format(
                    "cannot write '{}': what lies below {} is not a file; - stands for the standard output",
                    name, system));
            }
        }
        const fs::path link = fs::read_symlink(target, failed);
        if (failed) {
            return target.string();
        }
        if (links == most_links) {
            throw InputError(fmt::format("cannot write '{}': its links lead in a circle", name));
        }
        target = target.parent_path() / link;
    }
}

void write_atomically(const std::string& path, const Writing& write, Survives whose_death) {
    require_place_for_file(path);
    Temporary file(path);
    const Sink to_file = [&](std::string_view bytes) { file.write(bytes); };
    if (path.ends_with(".gz")) {
        Gzip packed(to_file);
        write([&](std::string_view part) { packed.add(part); });
        packed.end();
    } else {
        write(to_file);
    }
    file.inherit();
    if (whose_death == Survives::machine) {
        file.sync();
    }
    file.give_final_name();
    if (whose_death == Survives::machine) {
        sync_folder_of(path);
    }
}

void write_atomically(const std::string& path, const std::string& contents, Survives whose_death) {
    write_atomically(
        path, [&](const Sink& sink) { sink(contents); }, whose_death);
}

AtomicFile::AtomicFile(std::string path) : path_(std::move(path)) {
    require_place_for_file(path_);
    const Temporary probe(path_);
}

}  // namespace dumbbell
