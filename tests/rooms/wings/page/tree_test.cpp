#include "page/tree.hpp"

#include <algorithm>
#include <numeric>

#include "base/error.hpp"
#include "catch.hpp"

using namespace dumbbell;
using namespace dumbbell::page;

namespace {

constexpr int across = split_of(0);
constexpr int up = split_of(1);

// Split `depth` times towards the lower half, leaves of the kinds 0, 1, ..., depth from the top.
PictureTree one_sided(int depth) {
    PictureTree tree(static_cast<std::size_t>(depth), across);
    for (int kind = depth; kind >= 0; --kind) {
        tree.push_back(kind);
    }
    return tree;
}

// All leaves at the same depth, of kind 7 but one of kind 9.
PictureTree full(int depth) {
    if (depth == 0) {
        return {7};
    }
    PictureTree tree{depth % 2 == 0 ? across : up};
    for (int half = 0; half < 2; ++half) {
        const PictureTree subtree = full(depth - 1);
        tree.insert(tree.end(), subtree.begin(), subtree.end());
    }
    return tree;
}

bool is_complete(const PictureTree& tree) {
    long missing = 1;
    for (const int node : tree) {
        missing += node < 0 ? 1 : -1;
    }
    return missing == 0;
}

}  // namespace

TEST_CASE("a tree that is small enough is drawn as it is") {
    const PictureTree tree{across, up, 3, 1, 2};
    for (const std::size_t most : {3, 4, 1000}) {
        const ThinnedTree drawn = thinned(tree, most);
        CHECK(drawn.nodes == tree);
        CHECK(drawn.stands_for.empty());
    }
    CHECK(leaves_of(tree) == 3);
    CHECK(thinned({5}, 1).nodes == PictureTree{5});
}

TEST_CASE("a thinned tree is complete, small enough, and its leaves stand for all leaves") {
    for (const PictureTree& tree : {one_sided(40), full(9)}) {
        for (const std::size_t most : {1, 2, 3, 10, 39, 40}) {
            const ThinnedTree drawn = thinned(tree, most);
            CAPTURE(tree.size(), most);
            CHECK(is_complete(drawn.nodes));
            CHECK(leaves_of(drawn.nodes) == std::min(most, leaves_of(tree)));
            REQUIRE(drawn.stands_for.size() == leaves_of(drawn.nodes));
            CHECK(std::accumulate(drawn.stands_for.begin(), drawn.stands_for.end(), std::size_t{0}) ==
                  leaves_of(tree));
        }
    }
}

TEST_CASE("a leaf that stands for several has the greatest of their kinds") {
    CHECK(thinned({across, up, 3, 9, 2}, 1).nodes == PictureTree{9});
    const ThinnedTree drawn = thinned({across, up, 3, 9, 2}, 2);
    CHECK(drawn.nodes == PictureTree{across, 9, 2});
    CHECK(drawn.stands_for == std::vector<std::size_t>{2, 1});
}

TEST_CASE("large boxes are shown in detail before small ones with as many leaves") {
    // Two leaves at depth 1, two at depth 4, and single ones between.
    const PictureTree tree{across, across, 1, 2, across, 3, across, 4, across, 5, 6};
    const ThinnedTree drawn = thinned(tree, 5);
    CHECK(drawn.nodes == PictureTree{across, across, 1, 2, across, 3, across, 4, 6});
    CHECK(drawn.stands_for == std::vector<std::size_t>{1, 1, 1, 1, 2});
}

TEST_CASE("a tree as deep as it is large is no trouble") {
    const ThinnedTree drawn = thinned(one_sided(300'000), 1000);
    CHECK(leaves_of(drawn.nodes) == 1000);
    CHECK(is_complete(drawn.nodes));
}

TEST_CASE("a tree that is not complete is a broken invariant") {
    for (const PictureTree& tree :
         {PictureTree{}, PictureTree{across}, PictureTree{across, 1}, PictureTree{1, 2}}) {
        CHECK_THROWS_AS(thinned(tree, 10), BrokenInvariant);
    }
}

TEST_CASE("trees share the boxes of a page by their leaves, and each gets one") {
    CHECK(share_of(10, {100, 100}) == 10);
    CHECK(share_of(10, {100, 1000}) == 10);
    CHECK(share_of(10, {100, 50}) == 5);
    CHECK(share_of(1, {100, 10}) == 1);
}
