#pragma once

#include <CLI/App.hpp>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "file/atomic_file.hpp"

namespace dumbbell {

/// What a command writes, which its file's name must say.
enum class Content { certificate, table, picture, page, parts };

/// Adds --out FILE to a command, for `file`, which outlives it. A name that is empty or that of a directory,
/// that does not end as the content's names do, or that lies where no files are (`output_target`) is refused
/// when the command line is read; `-`, the standard output, is not.
CLI::Option* add_out_option(CLI::App& command, std::string& file, const std::vector<Content>& contents,
                            const char* text = "write the certificate to FILE (FILE.gz: compressed)");

/// Throws InputError unless the name is one for this content.
void require_name_of(const std::string& file, Content content);

/// What --out names: a file, the standard output (`-`), or nothing (an empty name).
class Output {
  public:
    /// Finds out at once whether the file can be written. Throws InputError if not, if it is one of the
    /// `inputs`, also through links, or if `beside` (an option, or null) writes to the standard output, too.
    explicit Output(const std::string& file, const std::vector<std::string>& inputs = {},
                    const char* beside = nullptr);

    [[nodiscard]] bool is_wanted() const { return !name_.empty(); }
    /// The file's name, as it was given; none of the standard output.
    [[nodiscard]] std::optional<std::string> file() const {
        return file_ ? std::optional(name_) : std::nullopt;
    }
    /// Where the command says what came out: the standard output, or stderr if that has the data.
    [[nodiscard]] std::FILE* report() const { return is_wanted() && !file_ ? stderr : stdout; }

    /// Throws InputError if it cannot be written.
    void commit(const std::string& contents) const;

  private:
    std::string name_;
    std::optional<AtomicFile> file_;
};

}  // namespace dumbbell
