#include "base/growing_tree.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "catch.hpp"

using namespace dumbbell;

namespace {

struct Node {
    std::optional<int> split;
    std::string leaf;
};

/// A box is its path from the root, and so is the leaf that closes it.
struct Grown {
    std::string text;  ///< of the nodes in pre-order
    std::size_t nodes = 0;
    std::size_t most_boxes = 0;
};
Grown grown(std::size_t most_together) {
    GrowingTree<Node, std::string, 2> tree("", most_together);
    Grown result;
    for (; !tree.boxes().empty(); tree.next_generation()) {
        result.most_boxes = std::max(result.most_boxes, tree.boxes().size());
        for (std::size_t i = 0; i < tree.boxes().size(); ++i) {
            const std::string path = tree.boxes()[i];
            const auto& depths = tree.depths(i);
            REQUIRE(static_cast<std::size_t>(depths[0] + depths[1]) == path.size());
            const auto zeros = std::count(path.begin(), path.end(), '0');
            if (path.size() == 9 || (path.size() > 3 && zeros % 3 == 0)) {
                tree.close(i, path);
            } else {
                tree.split(i, static_cast<int>(path.size() % 2), {path + '0', path + '1'});
            }
        }
    }
    result.nodes = tree.nodes();
    std::size_t count = 0;
    for (const Node& node : std::move(tree).pre_order()) {
        result.text += node.split ? std::to_string(*node.split) + '\n' : node.leaf + '\n';
        ++count;
    }
    CHECK(count == result.nodes);
    return result;
}

/// The same tree, from its definition.
std::string expected(const std::string& path) {
    const auto zeros = std::count(path.begin(), path.end(), '0');
    return path.size() == 9 || (path.size() > 3 && zeros % 3 == 0)
               ? path + '\n'
               : std::to_string(path.size() % 2) + '\n' + expected(path + '0') + expected(path + '1');
}

}  // namespace

TEST_CASE("a growing tree is the same whatever the number of boxes that wait together") {
    const Grown whole = grown(1'000'000);
    CHECK(whole.text == expected(""));
    CHECK(whole.most_boxes > 40);
    for (const std::size_t most : {1U, 2U, 7U, 40U}) {
        CAPTURE(most);
        const Grown limited = grown(most);
        CHECK(limited.text == whole.text);
        CHECK(limited.nodes == whole.nodes);
        CHECK(limited.most_boxes == most);
    }
}
