// Leaves as rows of a table (near_leaves.tsv): what one says in words, a tab, and what the verifier says of
// it.
#pragma once
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "verify/core/section.hpp"
#include "verify/sections/cell.hpp"
#include "verify/wings/starts/grammar.hpp"

namespace leaf_rows {

namespace starts = dumbbell_verify::starts;

using dumbbell_verify::Cell;
using dumbbell_verify::Leaf;
using dumbbell_verify::Section;

/// A leaf of the section, in its table of opcodes and charts.
struct SectionLeaf {
    const Section* section;
    Leaf leaf;
};
/// The box of a file about initial conditions, above the floor.
struct Start {
    dumbbell_verify::starts::Box box;
};
using AnyLeaf = std::variant<SectionLeaf, starts::Leaf, Start, Cell>;

struct Row {
    std::string leaf, result;
};

/// `certified`, or what is missing.
inline std::string judged(const AnyLeaf& any) try {
    const char* missing = nullptr;
    if (const auto* one = std::get_if<SectionLeaf>(&any))
        missing = one->section->check(one->leaf, nullptr);
    else if (const auto* start = std::get_if<Start>(&any))
        missing = dumbbell_verify::starts::starts_in_the_air(start->box, 53) ? nullptr : "not in the air";
    else if (const auto* cell = std::get_if<Cell>(&any))
        missing = dumbbell_verify::judged<dumbbell_verify::CellRule>(*cell, nullptr);
    else
        missing = dumbbell_verify::starts::check_leaf(std::get<starts::Leaf>(any), nullptr);
    return missing ? missing : "certified";
} catch (const std::length_error& error) {
    return error.what();
}

/// Bits of a row: 0 is double, else MPFR with this many, which may be fewer than a file may ask for.
inline void set_bits(auto& leaf, unsigned bits) {
    leaf.multiple = bits > 0;
    leaf.bits = bits > 0 ? bits : 53;
}
inline unsigned bits_of(const auto& leaf) { return leaf.multiple ? leaf.bits : 0; }

inline std::string words(const AnyLeaf& any) {
    std::ostringstream out;
    const auto box = [&](const auto& sides, std::size_t axes) {
        for (std::size_t i = 0; i < axes; ++i)
            out << " " << sides.lo[i].get_str() << " " << sides.hi[i].get_str();
    };
    if (const auto* one = std::get_if<SectionLeaf>(&any)) {
        const auto& [section, leaf] = *one;
        out << section->lemmas << " " << section->scene << " " << section->name << " "
            << section->charts[leaf.chart].name << " " << section->opcodes[leaf.opcode].name << " "
            << bits_of(leaf) << " " << leaf.a.get_str() << " " << leaf.b.get_str() << " "
            << leaf.claimed.get_str();
        box(leaf.box, section->charts[leaf.chart].axes.size());
    } else if (const auto* start = std::get_if<Start>(&any)) {
        out << "start";
        box(start->box, start->box.lo.size());
    } else if (const auto* cell = std::get_if<Cell>(&any)) {
        out << "cell " << bits_of(*cell) << " " << cell->upper.get_str() << " " << cell->lower.get_str()
            << " " << cell->j.get_str() << " " << cell->p.get_str();
        box(cell->box, cell->box.lo.size());
        for (const auto& [x, p] : cell->orbits) out << " " << x.get_str() << " " << p.get_str();
        out << " " << cell->end.get_str();
    } else {
        const auto& leaf = std::get<starts::Leaf>(any);
        out << "initial " << bits_of(leaf) << " " << leaf.least << " " << leaf.most;
        if (leaf.first)
            out << (leaf.first->heavy ? " heavy " : " light ") << leaf.first->from.get_str() << " "
                << leaf.first->until.get_str();
        else
            out << " anywhere 0 0";
        box(leaf.box, leaf.box.lo.size());
    }
    return out.str();
}

inline AnyLeaf parsed(const std::string& text) {
    std::istringstream in(text);
    const auto word = [&] {
        std::string w;
        if (!(in >> w)) throw std::runtime_error("a row with too few words: " + text);
        return w;
    };
    const auto number = [&] { return std::stoull(word()); };
    const auto box = [&](auto& sides, std::size_t axes) {
        for (std::size_t i = 0; i < axes; ++i) {
            sides.lo[i] = mpq_class(word());
            sides.hi[i] = mpq_class(word());
        }
    };
    const auto place = [&](const auto& table) {
        const std::string name = word();
        for (std::size_t i = 0; i < table.size(); ++i)
            if (table[i].name == name) return i;
        throw std::runtime_error("no " + name + ": " + text);
    };
    const std::string first = word();
    if (first == "start") {
        Start start;
        box(start.box, start.box.lo.size());
        return start;
    }
    if (first == "cell") {
        Cell cell;
        set_bits(cell, static_cast<unsigned>(number()));
        for (mpz_class* count : {&cell.upper, &cell.lower, &cell.j}) *count = mpz_class(word());
        cell.p = mpq_class(word());
        box(cell.box, cell.box.lo.size());
        cell.end = mpz_class(word());
        for (std::string p; in >> p; cell.end = mpz_class(word())) cell.orbits.emplace_back(cell.end, p);
        return cell;
    }
    if (first == "initial") {
        starts::Leaf leaf;
        set_bits(leaf, static_cast<unsigned>(number()));
        leaf.least = number();
        leaf.most = number();
        const std::string mass = word();
        const mpq_class from(word()), until(word());
        if (mass != "anywhere")
            leaf.first = dumbbell_verify::starts::FirstContact{mass == "heavy", from, until};
        box(leaf.box, leaf.box.lo.size());
        return leaf;
    }
    const std::string scene = word(), name = word();
    for (const Section* section : dumbbell_verify::sections()) {
        if (section->lemmas != first || section->scene != scene || section->name != name) continue;
        SectionLeaf result{section, {}};
        Leaf& leaf = result.leaf;
        leaf.chart = place(section->charts);
        leaf.opcode = place(section->opcodes);
        set_bits(leaf, static_cast<unsigned>(number()));
        leaf.a = mpz_class(word());
        leaf.b = mpz_class(word());
        leaf.claimed = mpz_class(word());
        box(leaf.box, section->charts[leaf.chart].axes.size());
        return result;
    }
    throw std::runtime_error("no such section: " + text);
}

inline std::vector<Row> read(const std::string& path) {
    std::ifstream in(path);
    if (!in) throw std::runtime_error("cannot read " + path);
    std::vector<Row> rows;
    for (std::string line; std::getline(in, line);) {
        const std::size_t tab = line.find('\t');
        if (line.empty() || line[0] == '#') continue;
        if (tab == std::string::npos) throw std::runtime_error("no tab: " + line);
        rows.push_back({line.substr(0, tab), line.substr(tab + 1)});
    }
    return rows;
}

}  // namespace leaf_rows
