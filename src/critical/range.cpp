#include "critical/range.hpp"

#include <atomic>

#include "base/deadline.hpp"
#include "number/parallel.hpp"
#include "number/self_test.hpp"

namespace dumbbell::critical {

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

}  // namespace dumbbell::critical
