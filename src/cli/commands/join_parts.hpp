#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/interrupted.hpp"
#include "cli/terminal/output.hpp"
#include "file/sealed_lines.hpp"
#include "number/rational.hpp"
#include "words/json.hpp"

/// What `dumbbell join` puts together, by kind.
namespace dumbbell::cli {

/// The mass ratios from `begin` to `end`; or the critical ratios of the N from `begin` on that are below
/// `end`.
struct Range {
    Rational begin, end;
};

/// What is known of a file.
struct PartFile {
    std::string name;
    std::string fault{};           ///< why it is not believed; empty: it is
    std::optional<Range> range{};  ///< of a file that is not believed what it claims, if that can be read
    /// Those that make it, but for its range; nothing if it does not tell.
    std::optional<std::string> options{};
    std::size_t pieces = 0, open = 0;
};

struct Joined {
    SealedText text;
    std::string sentence;  ///< what it proves
};

class Parts {
  public:
    Parts() = default;
    virtual ~Parts() = default;
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;

    [[nodiscard]] virtual Content content() const = 0;
    /// What --range says. Throws InputError.
    [[nodiscard]] virtual Range parse_range(const std::string& text) const = 0;

    /// Checks the file, the i-th of all, on so many threads, and keeps what it says. Of different files by
    /// different threads at once. Throws NoVerdict.
    [[nodiscard]] virtual PartFile take(std::size_t i, const std::string& name, int jobs,
                                        const Interrupted& interrupted) = 0;

    [[nodiscard]] virtual std::string words(const Range& range) const = 0;
    [[nodiscard]] virtual Json range_json(const Range& range) const = 0;
    /// The command that makes such a part, but for where it writes.
    [[nodiscard]] virtual std::string command(const Range& range, const std::string& options) const = 0;

    /// All of them in this order, in which each begins where the one before ends. They have the same options.
    [[nodiscard]] virtual Joined join(const std::vector<std::size_t>& order) = 0;
};

/// Of so many certificates; `gap` is for the commands.
[[nodiscard]] std::unique_ptr<Parts> certificate_parts(std::size_t files, std::string gap);
/// Of so many tables of critical ratios.
[[nodiscard]] std::unique_ptr<Parts> table_parts(std::size_t files);

}  // namespace dumbbell::cli
