#include "staircase/critical_table.hpp"

#include <fmt/core.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

#include "base/error.hpp"
#include "base/fields.hpp"
#include "collisions/writer.hpp"
#include "file/sha256.hpp"
#include "number/rational.hpp"

namespace dumbbell::staircase {
namespace {

constexpr std::string_view first_words = "# Critical mass ratios";
constexpr std::size_t columns = 6;
constexpr std::size_t longest = 200'000;  // of a line: more digits than `critical` gives

/// The file line by line, gzip or not.
class TableLines {
  public:
    explicit TableLines(const std::string& path) : file_(nullptr, &gzclose) {
        if (std::filesystem::is_regular_file(path)) {
            file_.reset(gzopen(path.c_str(), "rb"));
        }
    }

    /// With its line feed, if it has one and is not too long; nothing at the end.
    std::optional<std::string> next() {
        std::string line;
        std::array<char, 8192> part{};
        while (file_ && line.size() < longest &&
               gzgets(file_.get(), part.data(), static_cast<int>(part.size())) != nullptr) {
            line += part.data();
            if (line.ends_with('\n')) {
                break;
            }
        }
        return line.empty() ? std::nullopt : std::optional(std::move(line));
    }

    [[nodiscard]] bool at_end() const { return file_ && gzeof(file_.get()) == 1; }

  private:
    std::unique_ptr<gzFile_s, int (*)(gzFile)> file_;
};

std::optional<long> natural(std::string_view text) {
    const auto value = number_of<long>(text);
    return value && *value >= 0 ? value : std::nullopt;
}

bool is_number(std::string_view text) {
    try {
        (void)parse_rational(text, longest);
        return true;
    } catch (const InputError&) {
        return false;
    }
}

std::optional<CriticalTableRow> row_from(std::string_view line) {
    const auto fields = split(line, '\t');
    if (fields.size() != columns) {
        return std::nullopt;
    }
    const auto n = natural(fields[0]);
    const auto bits = natural(fields[3]);
    const auto flight = natural(fields[5]);
    const bool is_row = n && bits && flight && is_number(fields[1]) && is_number(fields[2]) &&
                        (fields[4] == "top" || fields[4] == "corner");
    return is_row ? std::optional(CriticalTableRow{*n, std::string(fields[1]), std::string(fields[2]), *bits,
                                                   std::string(fields[4]), *flight})
                  : std::nullopt;
}

}  // namespace

int CriticalTable::digits() const {
    long most = 1;
    for (const CriticalTableRow& row : rows) {
        most = std::max(most, std::ranges::count_if(row.q_c, [](char c) { return c >= '0' && c <= '9'; }));
    }
    return static_cast<int>(most);
}

bool is_critical_table(const std::string& path) {
    const auto line = TableLines(path).next();
    return line && line->starts_with(first_words);
}

CriticalTable read_critical_table(const std::string& path) {
    TableLines lines(path);
    CriticalTable table;
    std::string text;
    long number = 0;
    const auto fail = [&] {
        throw InputError(fmt::format(
            "'{}' is not a table of critical ratios that this program can read (line {})", path, number));
    };
    while (const auto line = lines.next()) {
        ++number;
        text += *line;
        if (!line->ends_with('\n')) {
            fail();
        }
        if (line->starts_with('#')) {
            continue;
        }
        auto row = row_from(std::string_view(*line).substr(0, line->size() - 1));
        if (!row) {
            fail();
        }
        table.rows.push_back(std::move(*row));
    }
    if (!lines.at_end() || table.rows.empty()) {
        ++number;
        fail();
    }
    table.sha256 = sha256_hex(text);
    return table;
}

}  // namespace dumbbell::staircase
