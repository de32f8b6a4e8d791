#include "starts/answer/shares.hpp"

#include <fmt/core.h>

#include <map>
#include <utility>

#include "base/error.hpp"

namespace dumbbell::starts {
namespace {

/// The volumes of the leaves of a tree, whose nodes are given in pre-order.
class Volumes {
  public:
    std::map<long, Rational> exact;  ///< by number of collisions
    std::map<long, Rational> change{
        {0, 0}};  ///< from k - 1 to k, of the leaves whose bounds have k between them
    Rational open = 0;
    Rational least_mean = 0, most_mean = 0;  ///< of the leaves that are not open

    void add(const Node& node) {
        require(!waiting_.empty(), "nodes follow the end of a tree of initial conditions");
        const Rational volume = std::move(waiting_.back());
        waiting_.pop_back();
        if (node.split) {
            waiting_.insert(waiting_.end(), 2, volume / 2);
        } else {
            add(node.leaf, volume);
        }
    }
    void end() const { require(waiting_.empty(), "a tree of initial conditions is not complete"); }

  private:
    void add(const Leaf& leaf, const Rational& volume) {
        if (!leaf.most) {
            open += volume;
            return;
        }
        if (leaf.least == *leaf.most) {
            exact[leaf.least] += volume;
        }
        least_mean += volume * leaf.least;
        most_mean += volume * *leaf.most;
        change[leaf.least] += volume;
        change[*leaf.most + 1] -= volume;
    }

    std::vector<Rational> waiting_{1};  ///< the volumes of the nodes to come: the next one last
};

/// x in [0, 1] with twelve decimals, rounded up or down.
std::string fixed(const Rational& x, bool up) {
    constexpr long one = 1'000'000'000'000;
    const Rational scaled = x * one;
    const long below = scaled.convert_to<long>(), units = below + (up && scaled > below ? 1 : 0);
    return fmt::format("{}.{:012}", units / one, units % one);
}

std::string counts_text(const ShareBounds& bounds) {
    return !bounds.most                   ? fmt::format("{}-", bounds.least)
           : *bounds.most == bounds.least ? fmt::format("{}", bounds.least)
                                          : fmt::format("{}-{}", bounds.least, *bounds.most);
}

std::vector<ShareBounds> bounds_of(const Volumes& volumes) {
    std::vector<ShareBounds> bounds;
    Rational hi = volumes.open;
    for (const auto& [count, change] : volumes.change) {
        if (!bounds.empty()) {
            bounds.back().most = count - 1;
        }
        hi += change;
        const auto exact = volumes.exact.find(count);
        bounds.push_back(
            {count, std::nullopt, exact == volumes.exact.end() ? Rational(0) : exact->second, hi});
    }
    if (volumes.open == 0) {
        bounds.pop_back();  // the rest has the share 0
    }
    return bounds;
}

}  // namespace

std::vector<ShareBounds> share_bounds(const PackedTree& tree) {
    Volumes volumes;
    tree.for_each([&](const Node& node) { volumes.add(node); });
    return bounds_of(volumes);
}

std::vector<ShareBounds> share_bounds(const std::vector<Node>& tree) {
    Volumes volumes;
    for (const Node& node : tree) {
        volumes.add(node);
    }
    volumes.end();
    return bounds_of(volumes);
}

MeanBounds mean_bounds(const PackedTree& tree) {
    Volumes volumes;
    tree.for_each([&](const Node& node) { volumes.add(node); });
    return {volumes.least_mean, volumes.open > 0 ? std::nullopt : std::optional(volumes.most_mean)};
}

std::string share_lines(const std::vector<ShareBounds>& bounds) {
    std::string text;
    for (const ShareBounds& b : bounds) {
        text += fmt::format("{:>12}  {} to {}\n", counts_text(b), fixed(b.lo, false), fixed(b.hi, true));
    }
    return text;
}

Json share_json(const std::vector<ShareBounds>& bounds) {
    Json json = Json::array();
    for (const ShareBounds& b : bounds) {
        json.add(Json::object(
            {{"least", b.least}, {"most", b.most}, {"lo", to_fraction(b.lo)}, {"hi", to_fraction(b.hi)}}));
    }
    return json;
}

}  // namespace dumbbell::starts
