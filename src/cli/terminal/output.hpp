#pragma once

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "cli/options/option.hpp"
#include "file/atomic_file.hpp"

namespace dumbbell::cli {

/// What a command writes, which its file's name must say.
enum class Content { certificate, table, picture, page };

/// What is wrong with a name to write to, empty if nothing is: one that is empty or that of a directory, that
/// does not end as the content's names do, or that lies where no files are (`output_target`); `-`, the
/// standard output, is none of these. Without a content every ending is right.
[[nodiscard]] std::string fault_of_name(const std::string& name, std::optional<Content> content);
template <Content content>
std::string fault_of_name(const std::string& name) {
    return fault_of_name(name, content);
}

/// Where a command writes its certificate.
inline constexpr Option certificate_option =
    Option{"--out", "FILE", "write the certificate to FILE (FILE.gz: compressed); -: the standard output"}
        .checked(fault_of_name<Content::certificate>);

/// Throws InputError unless the name is one for this content.
void require_name_of(const std::string& file, Content content);

/// What --out names: a file, the standard output (`-`), or nothing (an empty name).
class Output {
  public:
    /// Finds out at once whether the file can be written. Throws InputError if not, if it is one of the
    /// `inputs`, also through links, or if `other` (an option, or null) writes to the standard output, too.
    explicit Output(const std::string& file, const std::vector<std::string>& inputs = {},
                    const char* other = nullptr);

    [[nodiscard]] bool is_wanted() const { return !name_.empty(); }
    /// The file's name, as it was given; none of the standard output.
    [[nodiscard]] std::optional<std::string> file() const {
        return file_ ? std::optional(name_) : std::nullopt;
    }
    /// Where the command prints its results: the standard output, or stderr if that has the data.
    [[nodiscard]] std::FILE* report() const { return is_wanted() && !file_ ? stderr : stdout; }

    /// Throws InputError if it cannot be written.
    void commit(const Writing& write) const;
    void commit(const std::string& contents) const {
        commit([&](const Sink& sink) { sink(contents); });
    }

  private:
    std::string name_;
    std::optional<AtomicFile> file_;
};

}  // namespace dumbbell::cli
