#include "starts/packed_tree.hpp"

#include <fmt/core.h>

#include <charconv>
#include <cstdlib>
#include <utility>

#include "base/error.hpp"
#include "file/dyadic.hpp"

namespace dumbbell::starts {
namespace {

/// A split is `/AXIS `; a leaf `LEAST MOST `, MOST -1 if there is none, and behind that `. `, or `l T0 T1 `
/// or `h T0 T1 ` of a first contact.
void pack(std::string& text, const Node& node) {
    if (node.split) {
        text += fmt::format("/{} ", static_cast<int>(*node.split));
        return;
    }
    const Leaf& leaf = node.leaf;
    text += fmt::format("{} {} ", leaf.least, leaf.most.value_or(-1));
    text += leaf.first ? fmt::format("{} {} {} ", leaf.first->heavy ? 'h' : 'l', to_dyadic(leaf.first->from),
                                     to_dyadic(leaf.first->until))
                       : ". ";
}

/// The next word, which is taken off the text.
std::string_view word(std::string_view& text) {
    const std::size_t end = text.find(' ');
    require(end != std::string_view::npos, "a tree of initial conditions is not complete");
    const std::string_view result = text.substr(0, end);
    text.remove_prefix(end + 1);
    return result;
}

long whole(std::string_view text) {
    long result = 0;
    std::from_chars(text.data(), text.data() + text.size(), result);
    return result;
}

/// What to_dyadic wrote.
Rational dyadic(std::string_view text) {
    const std::size_t b = text.find('b');
    const Rational mantissa{Integer(std::string(text.substr(0, b)))};
    const long places = whole(text.substr(b + 1));
    const Rational power(Integer(1) << static_cast<unsigned>(std::abs(places)));
    return places < 0 ? mantissa / power : mantissa * power;
}

Node unpack(std::string_view& text) {
    const std::string_view first = word(text);
    if (first[0] == '/') {
        return {static_cast<Axis>(whole(first.substr(1))), {}};
    }
    const long most = whole(word(text));
    Leaf leaf{whole(first), most < 0 ? std::nullopt : std::optional(most)};
    if (const std::string_view mass = word(text); mass != ".") {
        const Rational from = dyadic(word(text));
        leaf.first = FirstContact{mass == "h", from, dyadic(word(text))};
    }
    return {{}, std::move(leaf)};
}

}  // namespace

void PackedTree::add(std::size_t generation, const Node& node) {
    if (generation == generations_.size()) {
        generations_.emplace_back();
    }
    pack(generations_.at(generation), node);
    ++size_;
}

void PackedTree::for_each(const std::function<void(const Node&)>& use) const {
    std::vector<std::string_view> rest(generations_.begin(), generations_.end());
    std::vector<std::size_t> waiting{0};  // the generations of the nodes to come
    while (!waiting.empty()) {
        const std::size_t generation = waiting.back();
        waiting.pop_back();
        require(generation < rest.size(), "a tree of initial conditions is not complete");
        const Node node = unpack(rest[generation]);
        if (node.split) {
            waiting.insert(waiting.end(), 2, generation + 1);
        }
        use(node);
    }
}

std::vector<Node> PackedTree::nodes() const {
    std::vector<Node> result;
    for_each([&](const Node& node) { result.push_back(node); });
    return result;
}

}  // namespace dumbbell::starts
