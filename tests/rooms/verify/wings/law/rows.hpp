// What the verifier computes for the law, as rows of a table (near_law.tsv): what is asked in words, a tab,
// and the verdict with all numbers of the log, digit by digit.
#pragma once
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "verify/core/ray.hpp"
#include "verify/wings/law/leaf.hpp"
#include "verify/wings/law/steps.hpp"

namespace law_rows {

namespace law = dumbbell_verify::law;

using dumbbell_verify::Big;

/// The numbers of a log without its facts.
inline std::string numbers(const std::string& log) {
    std::istringstream in(log);
    std::string result;
    int lines = 0;
    for (std::string line; std::getline(in, line);) {
        const bool is_fact = line.ends_with(": holds") || line.ends_with(": does NOT hold");
        // The window of the bulk has 1400 of them.
        if (!is_fact && (++lines <= 12 || lines % 97 == 0)) result += "; " + line.substr(2);
    }
    return result;
}

template <class N>
std::string constants() {
    dumbbell_verify::Log log;
    log.line({{"; ", dumbbell_verify::law::growth_constant<N>()},
              {"; ", dumbbell_verify::law::law_constant<N>()},
              {"; ", dumbbell_verify::law::comparison_constant<N>()},
              {"; ", dumbbell_verify::law::zeta_of_three_halves<N>()}});
    log.text.pop_back();  // the line's end
    return log.text;
}

/// `RULE BITS LO HI [LO HI]`, `bulk BITS RANGE LO HI [EPS EPS Q Q]` (with what is known of eps and of Q),
/// `places BITS N A B`, `window BITS`, `constant BITS` or `numbers BITS`. Bits: 0 is double, else MPFR with
/// as many, which may be fewer than a file may ask for.
inline std::string judged(const std::string& question) {
    std::istringstream in(question);
    const auto word = [&] {
        std::string w;
        if (!(in >> w)) throw std::runtime_error("a row with too few words: " + question);
        return w;
    };
    const std::string what = word();
    const auto bits = static_cast<unsigned>(std::stoul(word()));
    const bool multiple = bits > 0;
    dumbbell_verify::Log log;
    const auto said = [&](const char* missing) {
        return (missing ? missing : "certified") + numbers(log.text);
    };
    if (what == "window") return said(dumbbell_verify::law::check_bulk_window(bits, multiple, &log));
    if (what == "constant") return said(dumbbell_verify::law::check_constant(bits, multiple, &log));
    Big::precision = multiple ? bits : 53;
    if (what == "numbers") return "of the law" + (multiple ? constants<Big>() : constants<double>());
    if (what == "places") {
        const std::uint64_t n = std::stoull(word());
        const mpq_class a(word()), b(word());
        return said(multiple ? dumbbell_verify::law::StepPlaces<Big>().check(n, a, b)
                             : dumbbell_verify::law::StepPlaces<double>().check(n, a, b));
    }
    law::Leaf leaf;
    leaf.multiple = multiple;
    leaf.bits = multiple ? bits : 53;
    while (law::Leaf::names.at(leaf.rule) != what) leaf.rule = static_cast<law::Leaf::Rule>(leaf.rule + 1);
    if (leaf.rule == law::Leaf::bulk) leaf.range = std::stoul(word());
    for (std::size_t i = 0; i < (leaf.rule < law::Leaf::bulk ? 2 : 1); ++i) {
        leaf.box.lo.at(i) = mpq_class(word());
        leaf.box.hi.at(i) = mpq_class(word());
    }
    dumbbell_verify::law::States states;
    if (std::string least; in >> least) {
        states.least_eps = mpq_class(least);
        states.most_eps = mpq_class(word());
        states.least_Q = mpq_class(word());
        states.most_Q = mpq_class(word());
    }
    leaf.states = &states;
    if (leaf.rule == law::Leaf::bulk) return said(law::check_bulk(leaf, &log));
    return said(leaf.rule == law::Leaf::end ? law::check_end(leaf, &log) : law::check_layer(leaf, &log));
}

}  // namespace law_rows
