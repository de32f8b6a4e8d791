#include "campaign/order.hpp"

#include <fmt/core.h>

#include "base/error.hpp"
#include "file/sha256.hpp"

namespace dumbbell::campaign {

std::string Order::text() const {
    SealedLines out;
    out.line("dumbbell-order 1");
    out.line("generator dumbbell {}", DUMBBELL_VERSION);
    write_order(out, *this);
    return std::move(out).sealed().text;
}

std::string Order::id() const { return sha256_hex(text()).substr(0, 32); }

std::string Order::kind() const {
    constexpr std::string_view keyword = "prove ";
    require(head.starts_with(keyword), "an order without a kind");
    return head.substr(keyword.size(), head.find('\n') - keyword.size());
}

std::vector<std::string> head_values(const Order& order, std::initializer_list<std::string_view> words) {
    std::vector<std::string> values;
    std::string_view rest = order.head;
    for (const std::string_view word : words) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        if (line.size() == rest.size() || !line.starts_with(fmt::format("{} ", word))) {
            break;
        }
        values.emplace_back(line.substr(word.size() + 1));
        rest.remove_prefix(line.size() + 1);
    }
    if (values.size() < words.size() || !rest.empty()) {
        throw InputError("the order says what it is about in other words than this program knows");
    }
    return values;
}

void write_order(SealedLines& out, const Order& order) {
    out.lines(order.head);
    out.line("units {}", order.units.size());
    for (const std::string& unit : order.units) {
        out.line("{}", unit);
    }
}

Order read_order(SealedReader& in) {
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
    return order;
}

Order parse_order(const std::string& text) {
    SealedReader in(text, "an order of a campaign");
    if (in.line() != "dumbbell-order 1") {
        in.fail();
    }
    const std::string_view generator = in.value("generator");
    if (generator != "dumbbell " DUMBBELL_VERSION) {
        throw InputError(fmt::format(
            "the order comes from {}, and this is dumbbell {}: install the manager's version on this worker",
            generator, DUMBBELL_VERSION));
    }
    Order order = read_order(in);
    in.end();
    return order;
}

}  // namespace dumbbell::campaign
