#include "critical/range.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/deadline.hpp"
#include "flight/macro/when.hpp"
#include "number/parallel.hpp"
#include "number/self_test.hpp"

namespace dumbbell::critical {
namespace {

/// Flights that take as long as the request: n/2 for each orbit that is followed, and for a long one about as
/// many as for the first, times its digits beyond them.
double flights(const Request& request) {
    const auto number = [](long first, long last) {
        return static_cast<double>(std::max(0L, last - first + 1));
    };
    const long followed = std::min(request.last, flight::macro::first_long - 1);
    const long jumped = std::max(request.first, flight::macro::first_long);
    const double longer = static_cast<double>(request.last) / flight::macro::first_long;
    return number(request.first, followed) * static_cast<double>(request.first + followed) / 4 +
           number(jumped, request.last) * flight::macro::first_long / 2 *
               (1 + std::log10(std::max(1.0, longer)));
}

}  // namespace

std::vector<Row> enclose_ratios(const Request& request) {
    require_sound_arithmetic();
    const auto interrupted = deadline(request.budget);
    Options options{.digits = request.digits, .interrupted = interrupted};
    if (request.bodies && request.bodies->have_rods) {
        return enclose_falls(*request.bodies, options);
    }
    const bool one = request.first == request.last;
    if (one) {
        options.observer = request.observer;
    }
    std::vector<Row> rows(static_cast<std::size_t>(request.size()));
    std::atomic<std::size_t> done = 0;
    run_with_threads(request.jobs, [&] {
        in_parallel(rows.size(), [&](std::size_t i) {
            Row& row = rows[i];
            row.n = request.first + static_cast<long>(i);
            row.ratio = interrupted()    ? std::nullopt
                        : request.bodies ? enclose_inertia(*request.bodies, row.n, options)
                                         : enclose_ratio(row.n, options);
            if (!one) {
                request.observer->update(++done, rows.size(), row.n);
            }
        });
    });
    return rows;
}

double share_of_first(std::size_t ratios, const Request& request) {
    Request first = request;
    first.last = request.first + static_cast<long>(ratios) - 1;
    return flights(first) / flights(request);
}

}  // namespace dumbbell::critical
