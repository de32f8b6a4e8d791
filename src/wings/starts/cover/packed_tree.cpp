#include "starts/cover/packed_tree.hpp"

#include <cstdint>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "file/dyadic.hpp"

namespace dumbbell::starts {
namespace {

// The byte of a split is its axis, that of a leaf the sum of what it has.
constexpr unsigned is_leaf = 8, has_most = 16, has_first = 32, is_heavy = 64;

unsigned kind_of(const Leaf& leaf) {
    return is_leaf | (leaf.most ? has_most : 0U) | (leaf.first ? has_first : 0U) |
           (leaf.first && leaf.first->heavy ? is_heavy : 0U);
}

/// Seven bits a byte, the least first; but for the last byte with the eighth set.
void pack(std::string& bytes, std::uint64_t number) {
    for (; number >= 0x80; number >>= 7U) {
        bytes += static_cast<char>(number | 0x80U);
    }
    bytes += static_cast<char>(number);
}

/// Precondition: x > 0 is dyadic.
void pack(std::string& bytes, const Rational& x) {
    const auto [odd, places] = dyadic(x);
    pack(bytes,
         places < 0 ? 2 * static_cast<std::uint64_t>(-places) - 1 : 2 * static_cast<std::uint64_t>(places));
    std::string digits(msb(odd) / 8 + 1, '\0');
    mpz_export(digits.data(), nullptr, -1, 1, 0, 0, odd.raw());
    pack(bytes, digits.size());
    bytes += digits;
}

std::uint64_t unpack_number(std::string_view& bytes) {
    std::uint64_t number = 0;
    for (unsigned shift = 0;; shift += 7) {
        const auto byte = static_cast<unsigned char>(bytes.front());
        bytes.remove_prefix(1);
        number += static_cast<std::uint64_t>(byte & 0x7fU) << shift;
        if (byte < 0x80) {
            return number;
        }
    }
}

Rational unpack_dyadic(std::string_view& bytes) {
    const std::uint64_t code = unpack_number(bytes), places = (code + 1) / 2, size = unpack_number(bytes);
    Integer odd;
    mpz_import(odd.raw(), size, -1, 1, 0, 0, bytes.data());
    bytes.remove_prefix(size);
    Rational x(odd);
    code % 2 == 1 ? mpq_div_2exp(x.raw(), x.raw(), places) : mpq_mul_2exp(x.raw(), x.raw(), places);
    return x;
}

Leaf unpack_leaf(unsigned kind, std::string_view& bytes) {
    Leaf leaf{static_cast<long>(unpack_number(bytes))};
    if ((kind & has_most) != 0) {
        leaf.most = static_cast<long>(unpack_number(bytes));
    }
    if ((kind & has_first) != 0) {
        const Rational from = unpack_dyadic(bytes);
        leaf.first = FirstContact{(kind & is_heavy) != 0, from, unpack_dyadic(bytes)};
    }
    return leaf;
}

}  // namespace

void PackedTree::add(std::size_t generation, const Node& node) {
    if (generation == generations_.size()) {
        generations_.emplace_back();
    }
    auto& [kinds, leaves] = generations_.at(generation);
    ++size_;
    if (node.split) {
        kinds += static_cast<char>(*node.split);
        return;
    }
    const auto& [least, most, first] = node.leaf;
    kinds += static_cast<char>(kind_of(node.leaf));
    pack(leaves, static_cast<std::uint64_t>(least));
    if (most) {
        pack(leaves, static_cast<std::uint64_t>(*most));
    }
    if (first) {
        pack(leaves, first->from);
        pack(leaves, first->until);
    }
}

void PackedTree::for_each(const std::function<void(const Node&)>& use) const {
    std::vector<std::pair<std::string_view, std::string_view>> rest;
    for (const auto& [kinds, leaves] : generations_) {
        rest.emplace_back(kinds, leaves);
    }
    std::vector<std::size_t> waiting{0};  // the generations of the nodes to come
    while (!waiting.empty()) {
        const std::size_t generation = waiting.back();
        waiting.pop_back();
        require(generation < rest.size() && !rest[generation].first.empty(),
                "a tree of initial conditions is not complete");
        auto& [kinds, leaves] = rest[generation];
        const auto kind = static_cast<unsigned>(kinds.front());
        kinds.remove_prefix(1);
        if (kind < is_leaf) {
            waiting.insert(waiting.end(), 2, generation + 1);
            use({static_cast<Axis>(kind), {}});
        } else {
            use({{}, unpack_leaf(kind, leaves)});
        }
    }
}

std::vector<Node> PackedTree::nodes() const {
    std::vector<Node> result;
    for_each([&](const Node& node) { result.push_back(node); });
    return result;
}

void PackedTree::for_each_place(std::size_t generation, const std::function<void(const Place&)>& use) const {
    std::vector<std::size_t> next(generation, 0);  // node of each generation before
    std::vector<std::pair<std::size_t, Place>> waiting(1);
    while (!waiting.empty()) {
        const auto [here, place] = waiting.back();
        waiting.pop_back();
        if (here == generation) {
            use(place);
            continue;
        }
        const auto kind = static_cast<unsigned>(generations_.at(here).kinds.at(next[here]++));
        if (kind < is_leaf) {
            waiting.emplace_back(here + 1, place.half(static_cast<Axis>(kind), true));
            waiting.emplace_back(here + 1, place.half(static_cast<Axis>(kind), false));
        }
    }
}

}  // namespace dumbbell::starts
