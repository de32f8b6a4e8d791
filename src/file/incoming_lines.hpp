#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/interrupted.hpp"
#include "file/descriptor.hpp"

namespace dumbbell {

/// The lines of a text that people and other programs write, as they come: of a file, of a pipe, or of the
/// standard input (`-`). Every failure is an InputError that names it and says why it cannot be read.
class IncomingLines {
  public:
    /// Of a longer line only so many bytes are kept.
    static constexpr std::size_t longest_line = 8192;

    explicit IncomingLines(std::string path);

    /// The next line without its end, that of Unix or that of Windows, and without the byte-order mark of
    /// UTF-8. Nothing at the end of the text, and where it is interrupted, also while nothing comes.
    [[nodiscard]] std::optional<std::string> next(const Interrupted& interrupted = never);
    /// Of the line that came last; the first is 1.
    [[nodiscard]] long number() const { return number_; }
    [[nodiscard]] const std::string& path() const { return path_; }

  private:
    /// Reads more, unless the text ends or it is interrupted.
    void fill(const Interrupted& interrupted);
    [[noreturn]] void fail(std::string_view why) const;

    std::string path_;
    Descriptor file_;  ///< none: the standard input
    std::vector<char> block_;
    std::string_view rest_;  ///< of the block
    bool ended_ = false;
    long number_ = 0;
};

}  // namespace dumbbell
