#pragma once

#include <functional>
#include <string>
#include <vector>

#include "starts/cover/place.hpp"

namespace dumbbell::starts {

/// A bisection tree that is made generation by generation, in a byte for each split and some ten for each
/// leaf. A walk in pre-order, lower half first, reads each generation from its beginning to its end.
class PackedTree {
  public:
    /// The next node of a generation, from left to right. Precondition: the contacts in it are dyadic.
    void add(std::size_t generation, const Node& node);
    [[nodiscard]] std::size_t size() const { return size_; }

    /// In pre-order. Precondition: it is complete.
    void for_each(const std::function<void(const Node&)>& use) const;
    [[nodiscard]] std::vector<Node> nodes() const;

    /// The boxes of a generation, from left to right: they follow from the splits. `use` may add its nodes.
    /// Precondition: the generations before it are complete.
    void for_each_place(std::size_t generation, const std::function<void(const Place&)>& use) const;

  private:
    struct Generation {
        std::string kinds;   ///< of its nodes, a byte for each
        std::string leaves;  ///< what they say
    };

    std::vector<Generation> generations_;
    std::size_t size_ = 0;
};

}  // namespace dumbbell::starts
