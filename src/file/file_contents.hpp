#pragma once

#include <span>
#include <string>
#include <string_view>

#include "file/descriptor.hpp"

namespace dumbbell {

/// A file that is read from its beginning to its end. Every failure is an InputError that names it and says
/// why it cannot be read.
class FileToRead {
  public:
    explicit FileToRead(std::string path);

    /// Its next bytes, put into the room, which is not empty; none at its end.
    [[nodiscard]] std::string_view next(std::span<char> room);

    [[nodiscard]] const std::string& path() const { return path_; }

  private:
    [[noreturn]] void fail(std::string_view why) const;

    std::string path_;
    Descriptor file_;
};

/// All bytes of a file. Throws InputError, as above.
[[nodiscard]] std::string file_contents(const std::string& path);

}  // namespace dumbbell
