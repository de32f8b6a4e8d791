#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "starts/certificate.hpp"

namespace dumbbell::starts {

/// A bisection tree that is made generation by generation, in few bytes a node. Each generation is a text,
/// one node after another; a walk in pre-order, lower half first, reads each from its beginning to its end.
class PackedTree {
  public:
    /// The next node of a generation, from left to right. Precondition: the contacts in it are dyadic.
    void add(std::size_t generation, const Node& node);
    [[nodiscard]] std::size_t size() const { return size_; }

    /// In pre-order. Precondition: it is complete.
    void for_each(const std::function<void(const Node&)>& use) const;
    [[nodiscard]] std::vector<Node> nodes() const;

  private:
    std::vector<std::string> generations_;
    std::size_t size_ = 0;
};

}  // namespace dumbbell::starts
