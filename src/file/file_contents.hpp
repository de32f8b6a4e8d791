#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "file/descriptor.hpp"

namespace dumbbell {

/// A file by its name, and its bytes if it was read before: they are those that are read again.
struct NamedFile {
    NamedFile(const char* name) : path(name) {}             // NOLINT(google-explicit-constructor)
    NamedFile(std::string name) : path(std::move(name)) {}  // NOLINT(google-explicit-constructor)
    NamedFile(std::string name, std::string_view bytes) : path(std::move(name)), contents(bytes) {}

    std::string path;
    std::optional<std::string_view> contents{};
};

/// A file that is read from its beginning to its end. Every failure is an InputError that names it and says
/// why it cannot be read.
class FileToRead {
  public:
    explicit FileToRead(NamedFile file);

    /// Its next bytes, put into the room, which is not empty; none at its end.
    [[nodiscard]] std::string_view next(std::span<char> room);

    [[nodiscard]] const std::string& path() const { return named_.path; }

  private:
    [[noreturn]] void fail(std::string_view why) const;

    NamedFile named_;
    Descriptor file_;
};

/// All bytes of a file. Throws InputError, as above.
[[nodiscard]] std::string file_contents(const std::string& path);

}  // namespace dumbbell
