#include "audit/claimed_range.hpp"

#include <fmt/core.h>
#include <zlib.h>

#include <array>
#include <memory>

#include "base/error.hpp"

namespace dumbbell::audit {
namespace {

constexpr int head_lines = 8;

/// `P/Q`, of any length.
Rational ratio_from(std::string_view text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos || text.find_first_not_of("0123456789/") != std::string_view::npos) {
        throw InputError("not a ratio");
    }
    const std::string above(text.substr(0, slash));
    const std::string below(text.substr(slash + 1));
    if (above.empty() || below.empty() || above[0] == '0' || below[0] == '0' ||
        below.find('/') != std::string::npos) {
        throw InputError("not a ratio");
    }
    return {Integer(above), Integer(below)};
}

}  // namespace

std::pair<Rational, Rational> claimed_range(const std::string& path) {
    const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), &gzclose);
    std::array<char, 8192> buffer{};
    for (int i = 0; file && i < head_lines; ++i) {
        if (gzgets(file.get(), buffer.data(), static_cast<int>(buffer.size())) == nullptr) {
            break;
        }
        const std::string_view line(buffer.data());
        const std::size_t gap = line.find(' ', 6);
        if (line.starts_with("ratio ") && line.ends_with('\n') && gap != std::string_view::npos) {
            try {
                return {ratio_from(line.substr(6, gap - 6)),
                        ratio_from(line.substr(gap + 1, line.size() - gap - 2))};
            } catch (const InputError&) {
                break;
            }
        }
    }
    throw InputError(
        fmt::format("'{}' is not a certificate that this program can read (no line `ratio`)", path));
}

}  // namespace dumbbell::audit
