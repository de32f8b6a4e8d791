#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/terminal/output.hpp"
#include "file/sealed_lines.hpp"
#include "number/rational.hpp"

/// What `dumbbell join` puts together, by kind.
namespace dumbbell::cli {

/// The mass ratios from `begin` to `end`; of tables the N from `begin` on that are below `end`.
struct Range {
    Rational begin, end;
};

struct PartFile {
    std::string name;
    std::size_t number = 0;        ///< among all
    std::string fault{};           ///< why it is not believed; empty: it is
    std::optional<Range> range{};  ///< of a file that is not believed what it claims, if that can be read
    /// All parts have one; nothing if it does not tell.
    std::optional<std::string> kind{};
    std::size_t pieces = 0, open = 0;
};

class Parts {
  public:
    explicit Parts(Content content) : content_(content) {}
    virtual ~Parts() = default;
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;

    [[nodiscard]] Content content() const { return content_; }

    /// Checks the file, the i-th of all, on so many threads, and keeps what it says. By different threads at
    /// once for different files. Throws NoVerdict.
    [[nodiscard]] virtual PartFile take(std::size_t i, const std::string& name, int jobs) = 0;
    /// All files that were taken. Precondition: of one claim; each begins where the one before ends.
    [[nodiscard]] virtual SealedText join(const std::vector<PartFile>& files) = 0;

    /// What --range says. Throws InputError.
    [[nodiscard]] virtual Range parse_range(const std::string& text, const std::string& part) const = 0;
    [[nodiscard]] virtual std::string first(const Range& range) const = 0;
    [[nodiscard]] virtual std::string last(const Range& range) const = 0;
    /// They are about.
    [[nodiscard]] virtual std::string what() const = 0;
    /// `the mass ratios 1 to 100`.
    [[nodiscard]] std::string words(const Range& range) const {
        return what() + " " + first(range) + " to " + last(range);
    }
    /// That makes a part of this range, but for where it writes; `like` another file, if there is one.
    [[nodiscard]] virtual std::string command(const Range& range, const PartFile* like) const = 0;
    /// The name with an ending that the command takes.
    [[nodiscard]] std::string file_name(const std::string& name) const {
        return name + (fault_of_name(name, content_).empty() ? ""
                       : content_ == Content::table          ? ".tsv"
                                                             : ".dbc");
    }

  private:
    Content content_;
};

/// Of so many certificates; `gap` is for the commands, by default the widest of them all.
[[nodiscard]] std::unique_ptr<Parts> certificate_parts(std::size_t files, const std::optional<Rational>& gap);
/// Of so many tables of critical ratios.
[[nodiscard]] std::unique_ptr<Parts> table_parts(std::size_t files);

}  // namespace dumbbell::cli
