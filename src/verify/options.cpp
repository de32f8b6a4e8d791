#include "options.hpp"

#include <algorithm>
#include <regex>
#include <stdexcept>
#include <thread>

#ifndef DUMBBELL_VERSION
#define DUMBBELL_VERSION "0.0.0"
#endif

namespace dumbbell_verify {
namespace {

constexpr const char* help = R"(usage: dumbbell-verify [options] FILE...
Checks certificates (proofs/format.md) independently of the program that wrote them.

  --ratio RATIO|LO:HI  the mass ratios (heavy/light) in question; else those of the file
  --max N              demand the proof that no trajectory has more than N collisions
  --min N              demand the proof that some trajectory has at least N collisions
  --exactly N          both
  --scene S            demand this scene: dumbbell, hybrid or wedge (dumbbell)
  --claim KIND         demand this kind of claim: collisions, or initial-conditions (a file of `dumbbell trace
                       --subdivide`: then --ratio, --max, --min, --exactly are about the starts in its box)
  --lemma 4.1|4.2 A B  compare two files: at most as many collisions in A (scene hybrid) as in B (wedge), or
                       at most one more in A (dumbbell) than in B (hybrid)
  --jobs N             threads (all cores)
  --max-bits B         give up on pieces that need a higher precision (2048)
  --precision BITS     check with at least so many bits instead of in double
  --explain PIECE:PATH show one leaf with its inequalities: 3:bridge is the root, 3:light.01 the upper half
                       of its lower half, 3:witness the witness of the third piece; box.01 a leaf of a file
                       about initial conditions
  --json               print one JSON array and nothing else
  --help, --version

  dumbbell-verify --ratio 10 --exactly 4 ten.dbc       is N*(10) = 4 proved?
  dumbbell-verify --ratio 2:5/2 --max 3 stairs.dbc     at most 3 collisions on a part of the file's range?
  dumbbell-verify --explain 1:bridge.0 ten.dbc         one leaf, in numbers
  dumbbell-verify --claim initial-conditions --min 1 falling.dbc    at least one collision from every start?

Last line of each file: s VERIFIED, s REJECTED, s UNSUPPORTED, s UNREADABLE or s LIMIT. Exit code: 0 verified
and proved, 1 rejected, 2 usage or unreadable, 3 unsupported, 4 resource limit; of several codes the first
of 1, 4, 3, 2, 0.
)";

/// RATIO of the command line, exactly.
mpq_class parse_ratio(const std::string& text) {
    static const std::regex decimal("([0-9]+)(?:\\.([0-9]+))?(?:[eE]([+-]?)0*([0-9]{1,4}))?");
    static const std::regex fraction("([0-9]+)/([0-9]+)");
    std::smatch part;
    mpz_class top, bottom = 1;
    if (text.size() <= 1000 && std::regex_match(text, part, fraction)) {
        top = mpz_class(part.str(1), 10);
        bottom = mpz_class(part.str(2), 10);
    } else if (text.size() <= 1000 && std::regex_match(text, part, decimal)) {
        const unsigned long exponent = part[4].matched ? std::stoul(part.str(4)) : 0;
        if (exponent > 1000) throw std::invalid_argument("an exponent beyond 1000: " + text.substr(0, 60));
        top = mpz_class(part.str(1) + part.str(2), 10);
        mpz_class power;
        mpz_ui_pow_ui(power.get_mpz_t(), 10, exponent);
        (part.str(3) == "-" ? bottom : top) *= power;
        mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(part[2].length()));
        bottom *= power;
    }
    if (top == 0 || bottom == 0)
        throw std::invalid_argument("not a mass ratio: `" + text.substr(0, 60) + "`");
    mpq_class ratio(top, bottom);
    ratio.canonicalize();
    return ratio;
}

/// The interval of mass ratios >= 1 that RATIO or LO:HI stands for, exactly; below 1 the masses are swapped.
std::pair<mpq_class, mpq_class> parse_ratios(const std::string& text) {
    const std::size_t colon = text.find(':');
    const mpq_class lo = parse_ratio(text.substr(0, colon));
    const mpq_class hi = colon == std::string::npos ? lo : parse_ratio(text.substr(colon + 1));
    if (lo > hi) throw std::invalid_argument("LO:HI needs LO <= HI: " + text.substr(0, 60));
    if (lo < 1 && hi > 1)
        throw std::invalid_argument("a range across 1: split it at 1: " + text.substr(0, 60));
    return lo < 1 ? std::pair<mpq_class, mpq_class>(1 / hi, 1 / lo) : std::pair(lo, hi);
}

std::uint64_t natural(const std::string& text, std::uint64_t least, std::uint64_t most) {
    if (is_natural(text, 18))
        if (const std::uint64_t n = std::stoull(text); n >= least && n <= most) return n;
    throw std::invalid_argument("not a number from " + std::to_string(least) + " to " + std::to_string(most) +
                                ": `" + text.substr(0, 60) + "`");
}

}  // namespace

Options parse_options(int argc, char** argv) {
    Options result;
    result.settings.jobs = std::max(1U, std::thread::hardware_concurrency());
    bool options = true, scene = false;
    for (int i = 1; i < argc; ++i) {
        std::string option = argv[i];
        if (!options || !option.starts_with('-') || option == "-") {
            result.files.push_back(option);
            continue;
        }
        const std::size_t equals = option.find('=');
        const auto value = [&]() -> std::string {
            if (equals != std::string::npos) return option.substr(equals + 1);
            if (++i == argc) throw std::invalid_argument("no value behind " + option);
            return argv[i];
        };
        const auto number = [&](std::uint64_t least, std::uint64_t most) {
            return natural(value(), least, most);
        };
        const auto bits = [&] { return static_cast<unsigned>(number(53, 4096)); };
        const std::string name = option.substr(0, equals);
        constexpr std::uint64_t any = 999'999'999'999'999'999;
        if (name == "--ratio")
            result.settings.demand.ratios = parse_ratios(value());
        else if (name == "--max")
            result.settings.demand.most = number(0, any);
        else if (name == "--min")
            result.settings.demand.least = number(0, any);
        else if (name == "--exactly")
            result.settings.demand.most = result.settings.demand.least = number(0, any);
        else if (name == "--scene")
            result.settings.scene = value(), scene = true;
        else if (name == "--claim") {
            result.settings.claim = value();
            if (result.settings.claim != "collisions" && result.settings.claim != "initial-conditions")
                throw std::invalid_argument("--claim is collisions or initial-conditions");
        } else if (name == "--lemma") {
            const std::string lemma = value();
            result.lemma = find_lemma(lemma);
            if (!result.lemma)
                throw std::invalid_argument("no lemma `" + lemma.substr(0, 60) + "`: 4.1 or 4.2");
        } else if (name == "--jobs")
            result.settings.jobs = static_cast<unsigned>(number(1, 1024));
        else if (name == "--max-bits")
            result.settings.max_bits = bits();
        else if (name == "--precision")
            result.settings.precision = bits();
        else if (name == "--explain")
            result.settings.explain = value();
        else if (option == "--json")
            result.json = true;
        else if (option == "--")
            options = false;
        else if (option == "--help")
            result.answer = help;
        else if (option == "--version")
            result.answer = "dumbbell-verify " DUMBBELL_VERSION " (" __VERSION__ ")\n";
        else
            throw std::invalid_argument("unknown option " + option);
    }
    if (!result.answer.empty()) return result;
    if (result.files.empty()) throw std::invalid_argument("no FILE; see --help");
    if (result.json && !result.settings.explain.empty())
        throw std::invalid_argument("--explain and --json exclude each other");
    if (result.lemma) {
        const Settings& s = result.settings;
        if (result.files.size() != 2) throw std::invalid_argument("--lemma compares two files");
        if (result.json || scene || s.demand.most || s.demand.least || !s.explain.empty() || !s.claim.empty())
            throw std::invalid_argument(
                "--lemma excludes --json, --scene, --claim, --max, --min, --exactly, --explain");
        result.settings.demand.keep = true;
    }
    return result;
}

}  // namespace dumbbell_verify
