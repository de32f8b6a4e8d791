#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "file/file_contents.hpp"

struct z_stream_s;

namespace dumbbell {

/// The text of a file, plain or compressed as format.md, section 1, allows: one gzip member, and nothing
/// after it. Every failure is an InputError that names the file and says why it cannot be read or unpacked.
class UnpackedText {
  public:
    /// Twice as long as the format allows.
    static constexpr std::size_t longest_line = 8192;

    explicit UnpackedText(const NamedFile& file);

    /// The next line with its line feed; without one if the line is longer than the longest, or the text ends
    /// in it. Empty at the end of the text. Good until the next call.
    [[nodiscard]] std::string_view next_line();

  private:
    struct End {
        void operator()(z_stream_s* stream) const;
    };

    [[nodiscard]] std::string_view next_block();
    void feed(std::string_view packed);
    [[noreturn]] void damaged(std::string_view how) const;

    FileToRead file_;
    std::vector<char> read_, unpacked_;
    std::unique_ptr<z_stream_s, End> stream_;  ///< none: the file is plain
    bool ended_ = false;                       ///< the gzip member
    std::string_view rest_;                    ///< of the block
    std::string line_;
};

}  // namespace dumbbell
