#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/error.hpp"
#include "cli/commands/join_parts.hpp"
#include "file/sha256.hpp"
#include "number/count_argument.hpp"
#include "staircase/critical_table.hpp"

namespace dumbbell::cli {
namespace {

using staircase::CriticalReport;
using staircase::CriticalRow;

class TableParts : public Parts {
  public:
    explicit TableParts(std::size_t files) : tables_(files) {}

    [[nodiscard]] Content content() const override { return Content::table; }

    [[nodiscard]] Range parse_range(const std::string& text) const override {
        constexpr long any_number = greatest_count;
        const auto [first, last] = parse_counts(text, any_number);
        return {first, last + 1};
    }

    [[nodiscard]] PartFile take(std::size_t i, const std::string& name, int /*one*/,
                                const Interrupted& interrupted) override {
        PartFile file{name};
        try {
            CriticalReport& table = tables_[i] = staircase::read_critical_table(name);
            file.range = Range{table.request.first, table.request.last + 1};
            if (table.request.digits > 0) {
                file.options = fmt::format(" --digits {}", table.request.digits);
            }
            file.pieces = table.rows.size();
            file.open = static_cast<std::size_t>(
                std::ranges::count_if(table.rows, [](const CriticalRow& row) { return !row.ratio; }));
            const std::string objection = staircase::objection(table, interrupted);
            file.fault = objection.empty() ? "" : fmt::format("'{}' is not believed: {}", name, objection);
        } catch (const InputError& error) {
            file.fault = error.what();
        }
        return file;
    }

    [[nodiscard]] std::string words(const Range& range) const override {
        return fmt::format("the critical ratios for N from {} to {}", first(range), last(range));
    }

    [[nodiscard]] Json range_json(const Range& range) const override {
        return Json::object({{"lo", first(range)}, {"hi", last(range)}});
    }

    [[nodiscard]] std::string command(const Range& range, const std::string& options) const override {
        return fmt::format("dumbbell critical {}:{}{}", first(range), last(range), options);
    }

    [[nodiscard]] Joined join(const std::vector<std::size_t>& order) override {
        CriticalReport whole;
        whole.request.digits = 1;
        for (const std::size_t i : order) {
            whole.request.digits = std::max(whole.request.digits, tables_[i].request.digits);
            std::ranges::move(tables_[i].rows, std::back_inserter(whole.rows));
        }
        std::string text = to_tsv(whole);
        std::string sha256 = sha256_hex(text);
        return {{std::move(text), std::move(sha256)}, "Each is certain to be where the table says.\n"};
    }

  private:
    [[nodiscard]] static long first(const Range& range) { return range.begin.convert_to<long>(); }
    [[nodiscard]] static long last(const Range& range) { return range.end.convert_to<long>() - 1; }

    std::vector<CriticalReport> tables_;
};

}  // namespace

std::unique_ptr<Parts> table_parts(std::size_t files) { return std::make_unique<TableParts>(files); }

}  // namespace dumbbell::cli
