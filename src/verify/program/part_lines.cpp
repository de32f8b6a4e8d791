#include "verify/program/part_lines.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "verify/format/text.hpp"
#include "verify/program/version.hpp"

namespace dumbbell_verify {
namespace {

constexpr std::size_t most_line = 1 << 14;        // two ratios of a certificate have 8400 digits at most
constexpr std::uint64_t most_bytes = 1ULL << 30;  // millions of parts
constexpr std::string_view mark = "s PART ";

[[noreturn]] void unreadable(const std::string& text) {
    throw Failure{Verdict::unreadable, 0, "unreadable", text};
}

/// The text before the first separator, which goes with it; all if there is none.
std::string_view cut(std::string_view& text, char separator) {
    const std::size_t at = std::min(text.find(separator), text.size());
    const std::string_view head = text.substr(0, at);
    text.remove_prefix(std::min(at + 1, text.size()));
    return head;
}

/// `none` is 0; nothing if it is neither that nor one that --precision takes.
std::optional<unsigned> parse_precision(std::string_view text) {
    if (text == "none") return 0;
    if (!is_natural(text, 4)) return std::nullopt;
    const unsigned long bits = std::stoul(std::string(text));
    if (bits < 53 || bits > 4096) return std::nullopt;
    return static_cast<unsigned>(bits);
}

bool is_digest(std::string_view text) {
    return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

}  // namespace

PartLines::PartLines(std::string path) : path_(std::move(path)), file_(nullptr, std::fclose) {
    std::string why;
    file_.reset(open_file(path_, why));
    if (!file_) unreadable(path_ + ": " + why);
}

bool PartLines::next_line() {
    line_.clear();
    ++number_;
    while (true) {
        if (rest_.empty()) {
            rest_ = {block_.data(), std::fread(block_.data(), 1, block_.size(), file_.get())};
            if (std::ferror(file_.get()) != 0) unreadable(path_ + ": " + std::strerror(errno));
            if (rest_.empty()) return !line_.empty();
            bytes_ += rest_.size();
            if (bytes_ > most_bytes)
                throw Failure{Verdict::limit, 0, "limit", path_ + " has more than 1 GiB"};
        }
        const std::size_t size = std::min(rest_.find('\n'), rest_.size());
        const bool ended = size < rest_.size();
        if (line_.size() + size > most_line)
            unreadable(where() + ": a line of more than " + std::to_string(most_line) + " bytes");
        line_ += rest_.substr(0, size);
        rest_.remove_prefix(size + (ended ? 1 : 0));
        if (ended) return true;
    }
}

const PartLine* PartLines::next() {
    while (next_line()) {
        if (!line_.starts_with("s ")) continue;
        if (!line_.starts_with(mark) || !parse())
            unreadable(where() + ": not as dumbbell-verify --shards prints it: `" + line_.substr(0, 60) +
                       "`");
        return &part_;
    }
    return nullptr;
}

/// Another version may have other fields, in another order: this one is looked for wherever it stands.
void PartLines::require_this_version() const {
    for (std::string_view rest = part_.text; !rest.empty();) {
        std::string_view value = cut(rest, ' ');
        if (cut(value, '=') == "verifier" && value != version)
            throw Failure{Verdict::unsupported, 0, "unsupported",
                          where() + ": printed by dumbbell-verify " + std::string(value.substr(0, 60)) +
                              ", this is " + std::string(version) +
                              ": verify these pieces again with this one, by --shards"};
    }
}

bool PartLines::parse() {
    static const Fields names = fields({});
    part_.text = std::string_view(line_).substr(mark.size());
    require_this_version();
    std::string_view rest = part_.text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        std::string_view value = cut(rest, ' ');
        if (cut(value, '=') != names[i].name || value.empty()) return false;
        part_.values[i] = value;
    }
    const auto precision = parse_precision(part_.values[precision_field]);
    part_.pieces = parse_pieces(part_.values[pieces_field]);
    part_.precision = precision.value_or(0);
    return rest.empty() && precision && part_.pieces != Pieces{} && is_digest(part_.values[digest_field]);
}

}  // namespace dumbbell_verify
