#include "cluster/order.hpp"

#include <fmt/format.h>

#include "arith/error.hpp"
#include "cluster/sealed_lines.hpp"

namespace dumbbell {

std::string Order::text() const {
    SealedLines out;
    out.line("dumbbell-order 1");
    out.line("generator dumbbell {}", DUMBBELL_VERSION);
    out.lines(head);
    out.line("units {}", units.size());
    for (const std::string& unit : units) {
        out.line("{}", unit);
    }
    return std::move(out).sealed();
}

std::string Order::id() const { return sha256_hex(text()).substr(0, 32); }

std::string Order::kind() const {
    constexpr std::string_view keyword = "prove ";
    require(head.starts_with(keyword), "an order without a kind");
    return head.substr(keyword.size(), head.find('\n') - keyword.size());
}

Order parse_order(const std::string& text) {
    SealedReader in(text, "order of a campaign");
    if (in.line() != "dumbbell-order 1") {
        in.fail();
    }
    const std::string_view generator = in.value("generator");
    if (generator != "dumbbell " DUMBBELL_VERSION) {
        throw InputError(fmt::format(
            "the order comes from {}, and this is dumbbell {}: install the manager's version on this worker",
            generator, DUMBBELL_VERSION));
    }
    Order order;
    while (!in.ahead().empty() && !in.ahead().starts_with("units ")) {
        order.head += fmt::format("{}\n", in.line());
    }
    if (!order.head.starts_with("prove ")) {
        in.fail();
    }
    for (std::size_t count = in.number("units"); count > 0; --count) {
        order.units.emplace_back(in.line());
    }
    in.end();
    return order;
}

}  // namespace dumbbell
