// Files about the law for tests: the steps of the shipped certificate with a layer that is found here, and
// their mutants with a trailer that fits.
#pragma once
#include <stdexcept>

#include "rooms/verify/starts/make_file.hpp"
#include "verify/law/leaf.hpp"

namespace make {

namespace law = dumbbell_verify::law;

/// The totals and the hash that belong to this text.
inline std::string closed_law(const std::string& text) {
    std::map<std::string, int> count;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) ++count[line.substr(0, line.find(' '))];
    std::string all = text;
    for (const std::string kind : {"split", "count", "outside", "meets", "meets-reversed", "equal-masses",
                                   "witness", "slope", "beyond"})
        all += "total " + kind + " " + std::to_string(count[kind]) + "\n";
    return hashed(all);
}

/// A tree of the layer, whose leaves are as large as the verifier takes them.
inline std::string layer_tree(const dumbbell_verify::law::Box& box, int depth = 0) {
    law::Leaf leaf;
    leaf.box = box;
    if (depth > 40) throw std::runtime_error("the layer does not close");
    for (const auto rule : {law::Leaf::beyond, law::Leaf::slope}) {
        leaf.rule = rule;
        if (!law::check_layer(leaf, nullptr)) return std::string(law::Leaf::names.at(rule)) + "\n";
    }
    const std::size_t axis = box.hi[0] - box.lo[0] >= box.hi[1] - box.lo[1] ? 0 : 1;
    dumbbell_verify::law::Box lower = box, upper = box;
    lower.hi.at(axis) = upper.lo.at(axis) = (box.lo.at(axis) + box.hi.at(axis)) / 2;
    return std::string(axis == 0 ? "split U\n" : "split rho\n") + layer_tree(lower, depth + 1) +
           layer_tree(upper, depth + 1);
}

/// All up to the line `cover layer`, of the shipped certificate.
inline const std::string& law_steps() {
    static const std::string text = [] {
        gzFile file = gzopen(DUMBBELL_PROJECT "/certificates/law.dbc.gz", "rb");
        std::string all(4'000'000, '\0');
        const int size = file ? gzread(file, all.data(), static_cast<unsigned>(all.size())) : 0;
        if (file) gzclose(file);
        const std::size_t end = all.find("cover layer\n");
        if (size <= 0 || end == std::string::npos) throw std::runtime_error("certificates/law.dbc.gz");
        return all.substr(0, end);
    }();
    return text;
}
inline const std::string& law_layer() {
    static const std::string text = layer_tree({{0, 0}, {mpq_class(9, 10), mpq_class(1, 5)}});
    return text;
}
inline const std::string bulk_and_end = "cover bulk 4000 2000 4000\ncover end 1500\n";

inline const std::string& law_file() {
    static const std::string text = closed_law(law_steps() + "cover layer\n" + law_layer() + bulk_and_end);
    return text;
}
inline std::string mutated_law(const std::string& from, const std::string& to) {
    const std::string changed = replaced(law_file(), from, to);
    return closed_law(changed.substr(0, changed.find("total split")));
}
/// In step 9 A = 49/C^2 and a little, less than doubles can tell; the line after it is wrong, so that nothing
/// else is looked at.
inline std::string law_that_doubles_do_not_decide() {
    const std::string text =
        mutated_law("step 9 313/5 251/4", "step 9 6247778744831632773/100000000000000000 251/4");
    const std::size_t next = text.find("step 10 ");
    return hashed(text.substr(0, next) + "step 11" + text.substr(next + 7));
}
/// The line of the file that begins so.
inline std::string law_line(const std::string& begin) {
    const std::size_t at = law_file().find("\n" + begin) + 1;
    return law_file().substr(at, law_file().find('\n', at) - at);
}

}  // namespace make
