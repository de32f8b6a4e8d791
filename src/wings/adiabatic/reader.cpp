#include "adiabatic/reader.hpp"

#include <algorithm>

#include "adiabatic/writer.hpp"
#include "base/named.hpp"
#include "file/limits.hpp"
#include "file/lines.hpp"

namespace dumbbell::adiabatic {
namespace {

constexpr long most_classes = 64;
constexpr long most_cells = 4096;

std::pair<Rational, Rational> range_from(Lines& lines, std::string_view keyword) {
    const auto& fields = lines.expect(keyword, 3);
    return {lines.signed_ratio(fields[1]), lines.signed_ratio(fields[2])};
}

/// `with_class`: the leaves name the class that bounds them.
Tree tree_from(Lines& lines, bool with_class) {
    Tree tree;
    for (long missing = 1; missing > 0;) {
        const auto& fields = lines.next();
        Node node;
        if (fields[0] == "split" && fields.size() == 2) {
            const auto* const found = std::find(axis_names.begin(), axis_names.end(), fields[1]);
            if (found == axis_names.end()) {
                lines.fail();
            }
            node.split = static_cast<Axis>(found - axis_names.begin());
        } else if (fields[0] == "bound" && fields.size() == (with_class ? 2 : 1)) {
            node.by_class =
                with_class ? static_cast<int>(std::min(lines.number(fields[1]), most_classes)) : 0;
        } else if (fields[0] == "outside" && fields.size() == 1) {
            node.outside = true;
        } else {
            lines.fail();
        }
        missing += node.split ? 1 : -1;
        tree.push_back(node);
    }
    return tree;
}

std::vector<Class> classes_from(Lines& lines) {
    const long count = lines.number(lines.expect("classes", 2)[1]);
    if (count < 1 || count > most_classes) {
        lines.fail();
    }
    std::vector<Class> classes(static_cast<std::size_t>(count));
    for (Class& one : classes) {
        const auto& head = lines.expect("class", 3);
        one.least_share = lines.signed_ratio(head[1]);
        const long cells = lines.number(head[2]);
        if (cells > most_cells) {
            lines.fail();
        }
        for (long i = 0; i < cells; ++i) {
            const auto& cell = lines.expect("cell", 3);
            one.cells.push_back({lines.signed_ratio(cell[1]), lines.signed_ratio(cell[2])});
        }
        one.tree = tree_from(lines, false);
    }
    lines.expect("end", 1);
    return classes;
}

Hypotheses hypotheses_from(Lines& lines, Claim claim) {
    Hypotheses hypotheses;
    hypotheses.claim = claim;
    hypotheses.delta = range_from(lines, "delta");
    if (claim == Claim::bounce || claim == Claim::run) {
        hypotheses.heights = range_from(lines, "heights");
    }
    hypotheses.margin = lines.signed_ratio(lines.expect("margin", 2)[1]);
    if (claim == Claim::bounce) {
        hypotheses.exponent = static_cast<int>(std::min(lines.number(lines.expect("exponent", 2)[1]), 16L));
    }
    return hypotheses;
}

State attained_from(Lines& lines) {
    const auto& fields = lines.expect("attained", 6);
    return {lines.signed_ratio(fields[1]), lines.signed_ratio(fields[2]), lines.signed_ratio(fields[3]),
            lines.number(fields[4]), lines.signed_ratio(fields[5])};
}

/// What generated it, and the hypotheses.
Certificate head_from(Lines& lines) {
    const Head head = lines.expect_head();
    const auto claim = value_named<Claim>(head.claim);
    if (!claim) {
        lines.fail();
    }
    Certificate certificate;
    certificate.generator = head.generator;
    certificate.hypotheses = hypotheses_from(lines, *claim);
    return certificate;
}

}  // namespace

Certificate read_certificate(const NamedFile& file) {
    Lines lines(file);
    Certificate certificate = head_from(lines);
    const bool is_bounce = certificate.hypotheses.claim == Claim::bounce;
    certificate.bits =
        static_cast<int>(std::min(lines.number(lines.expect("bits", 2)[1]), long{most_file_bits}));
    const auto& bound = lines.expect("bound", is_bounce ? 3 : 2);
    for (std::size_t i = 1; i < bound.size(); ++i) {
        certificate.bounds.push_back(lines.signed_ratio(bound[i]));
    }
    if (!is_bounce) {
        certificate.classes = classes_from(lines);
    }
    certificate.tree = tree_from(lines, !is_bounce);
    for (int i = 0; i < (is_bounce ? 2 : 1); ++i) {
        certificate.attained.push_back(attained_from(lines));
    }
    certificate.sha256 = lines.digest();
    return certificate;
}

}  // namespace dumbbell::adiabatic
