#include "dumbbell/critical.hpp"

#include "api/caller_stops.hpp"
#include "api/checked.hpp"
#include "api/translate.hpp"
#include "base/error.hpp"
#include "critical/range.hpp"
#include "number/count_argument.hpp"
#include "number/decimal.hpp"

namespace dumbbell::api {
inline namespace DUMBBELL_ABI {
namespace {

critical::Request request_of(long n, const CriticalOptions& options) {
    critical::Request request;
    request.first = request.last = parse_counts(std::to_string(n)).first;
    request.digits = checked("digits", options.digits, 1, critical::most_digits);
    request.budget = options.budget;
    return request;
}

std::optional<CriticalRatio> given(const critical::Row& row, int digits) {
    if (!row.ratio) {
        return std::nullopt;
    }
    const auto shared = shared_digits(row.ratio->q_lo, row.ratio->q_hi, digits);
    require(shared.has_value(), "a critical ratio was not enclosed to the digits that were asked for");
    return CriticalRatio{to_text(cut_down(row.ratio->q_lo, digits + 2)),
                         to_text(cut_up(row.ratio->q_hi, digits + 2)), to_text(*shared)};
}

}  // namespace

std::optional<CriticalRatio> critical(long n, const CriticalOptions& options) {
    return guarded([&] {
        const CallerStops stops(options.stopped);
        return given(enclose_ratios(request_of(n, options)).front(), options.digits);
    });
}

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
