#include <fmt/core.h>

#include <algorithm>
#include <iterator>

#include "base/deadline.hpp"
#include "base/error.hpp"
#include "cli/commands/join_parts.hpp"
#include "critical/table.hpp"
#include "file/sha256.hpp"
#include "number/count_argument.hpp"

namespace dumbbell::cli {
namespace {

using critical::Report;

class TableParts : public Parts {
  public:
    explicit TableParts(std::size_t files) : Parts(Content::table), tables_(files) {}

    [[nodiscard]] PartFile take(std::size_t i, const std::string& name, int /*in_parallel's*/) override {
        PartFile file{name, i};
        try {
            Report& table = tables_[i] = critical::read_table(name);
            file.range = Range{table.request.first, table.request.last + 1};
            if (table.request.digits > 0) {
                file.kind = fmt::format(" --digits {}", table.request.digits);
            }
            file.pieces = table.rows.size();
            file.open = static_cast<std::size_t>(
                std::ranges::count_if(table.rows, [](const auto& row) { return !row.ratio; }));
            const std::string objection = critical::objection(table, deadline(std::nullopt));
            file.fault = objection.empty() ? "" : fmt::format("'{}' is refused: {}", name, objection);
        } catch (const InputError& error) {
            file.fault = error.what();
        }
        return file;
    }

    [[nodiscard]] SealedText join(const std::vector<PartFile>& files) override {
        Report whole;
        whole.request.digits = 1;
        for (const PartFile& file : files) {
            whole.request.digits = std::max(whole.request.digits, tables_[file.number].request.digits);
            std::ranges::copy(tables_[file.number].rows, std::back_inserter(whole.rows));
        }
        const std::string text = to_tsv(whole);
        return {text, sha256_hex(text)};
    }

    [[nodiscard]] Range parse_range(const std::string& text, const std::string& /*part*/) const override {
        constexpr long any_number = greatest_count;
        const auto [first, last] = parse_counts(text, any_number);
        return {first, last + 1};
    }
    [[nodiscard]] std::string first(const Range& range) const override {
        return numerator(range.begin).str();
    }
    [[nodiscard]] std::string last(const Range& range) const override {
        return numerator(range.end - 1).str();
    }

    [[nodiscard]] std::string what() const override { return "the critical ratios for N ="; }
    [[nodiscard]] std::string command(const Range& range, const PartFile* like) const override {
        return fmt::format("dumbbell critical {}:{}{}", first(range), last(range),
                           like == nullptr ? "" : like->kind.value_or(""));
    }

  private:
    std::vector<Report> tables_;
};

}  // namespace

std::unique_ptr<Parts> table_parts(std::size_t files) { return std::make_unique<TableParts>(files); }

}  // namespace dumbbell::cli
