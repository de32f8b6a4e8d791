#include <algorithm>
#include <random>

#include "mutations.hpp"

namespace dumbbell_mutation {
namespace {

class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    /// 0 to n - 1; the same on every platform. Precondition: n > 0.
    std::size_t below(std::size_t n) { return engine_() % n; }

  private:
    std::mt19937_64 engine_;
};

void change_once(Lines& lines, Random& random) {
    const std::size_t i = random.below(lines.size()), j = random.below(lines.size());
    const std::vector<TreeNode> nodes = nodes_of(lines);
    switch (random.below(8)) {
        case 0:
            lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(i));
            break;
        case 1:
            std::swap(lines[i], lines[j]);
            break;
        case 2:
            lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(i), lines[j]);
            break;
        case 3:  // one node of a tree by the text of another
            if (!nodes.empty())
                lines[nodes[random.below(nodes.size())].begin] =
                    lines[nodes[random.below(nodes.size())].begin];
            break;
        case 4: {  // a subtree by a leaf
            if (nodes.empty()) break;
            const TreeNode& node = nodes[random.below(nodes.size())];
            const std::string leaf = lines[node.end - 1];
            lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(node.begin),
                        lines.begin() + static_cast<std::ptrdiff_t>(node.end));
            lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(node.begin), leaf);
            break;
        }
        default: {
            const auto changed = changed_lines(lines[i]);
            if (!changed.empty()) lines[i] = changed[random.below(changed.size())].line;
        }
    }
}

}  // namespace

void random_mutations(const std::string& text, std::uint64_t seed, std::size_t count, const Sink& sink) {
    Random random(seed);
    for (std::size_t k = 0; k < count; ++k) {
        Lines lines = lines_of(body_of(text));
        for (std::size_t changes = 2 + random.below(3); changes > 0 && !lines.empty(); --changes)
            change_once(lines, random);
        sink({"several changes", "seed " + std::to_string(seed) + " number " + std::to_string(k),
              text_of(lines)});
    }
}

}  // namespace dumbbell_mutation
