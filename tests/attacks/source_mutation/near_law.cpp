// near_law make SEED NUMBER: questions to the verifier's law, with its answers (near_law.tsv).
//
// Random boxes of all rules, in double and in MPFR, also with so few bits that a bound rounded to the wrong
// side is off by a percent; and of the places of steps those that are just allowed, and just not, by
// bisection.
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>

#include "near_main.hpp"
#include "rooms/verify/wings/law/rows.hpp"

namespace {

class Maker {
  public:
    explicit Maker(std::uint64_t seed) : random_(seed) {}

    void make(int number) {
        for (const int bits : {0, 8, 11, 16, 24, 53}) print("numbers " + std::to_string(bits));
        for (const int bits : {0, 13, 24, 53}) print("constant " + std::to_string(bits));
        for (const int bits : {0, 13, 17, 20, 24}) print("window " + std::to_string(bits));
        for (int i = 0; i < number; ++i) {
            bits_ = std::to_string(std::array{0, 0, 0, 11, 16, 24}[below(6)]);
            if (i % 6 < 4)
                layer();
            else if (i % 6 == 4)
                print("bulk " + std::string(std::array{"0", "0", "20", "24"}[below(4)]) + " " +
                      std::to_string(below(3)) + side(uniform(0, 0.8), 0.01));
            else
                print("end " + bits_ + side(any_size(1e-6, 0.09)));
            if (i % 8 == 0) places();
            if (i % 16 == 0) known();
        }
    }

  private:
    std::uint64_t below(std::uint64_t n) { return random_() % n; }
    double uniform(double lo, double hi) { return std::uniform_real_distribution<>(lo, hi)(random_); }
    double any_size(double lo, double hi) { return lo * std::pow(hi / lo, uniform(0, 1)); }
    /// A number of few digits, 0 as well.
    static mpq_class rounded(double x) {
        const double digits = std::exp2(6 - std::floor(std::log2(x)));
        return mpq_class(std::round(x * digits) / digits);
    }
    static void print(const std::string& question) {
        std::cout << question << "\t" << law_rows::judged(question) << "\n";
    }

    /// A side that begins at x, or now and then at 0, up to this share of it wide.
    std::string side(double x, double most = 0.3) {
        const mpq_class lo = below(6) == 0 ? mpq_class(0) : rounded(x);
        const mpq_class hi = below(3) == 0 ? lo : mpq_class(lo + rounded(x * any_size(1e-4, most)));
        return " " + lo.get_str() + " " + hi.get_str();
    }
    void layer() {
        const std::string rule = std::array{"slope", "slope", "slope", "slope", "beyond"}[below(5)];
        const double U = below(2) == 0 && rule != "beyond" ? any_size(1e-4, 0.9) : uniform(0.01, 0.95);
        const double rho = any_size(1e-4, std::min(0.2, (rule == "beyond" ? 2e-2 : 3e-3) / (U * U)));
        print(rule + " " + bits_ + side(U) + side(rho));
    }

    /// A part of the bulk with a certain eps and Q, and what is known of Q just enough, and just not, for the
    /// last angle.
    void known() {
        const std::string leaf = "bulk " + std::string(std::array{"0", "0", "18", "20", "24"}[below(5)]) +
                                 " 0" + side(uniform(0.1, 0.6), 0.001);
        const mpq_class eps = rounded(any_size(1e-7, 1e-3)), Q = rounded(uniform(0, 3e-5));
        const auto question = [&](const mpq_class& least, const mpq_class& most) {
            return leaf + " " + eps.get_str() + " " + eps.get_str() + " " + least.get_str() + " " +
                   most.get_str();
        };
        print(question(Q, Q));
        const auto holds = [&](const mpq_class& least, const mpq_class& most) {
            return law_rows::judged(question(least, most)).find("Q/cos") != 0;
        };
        if (!holds(Q, Q)) return;
        for (const int sign : {-1, 1}) {
            mpq_class good = Q, bad = mpq_class(sign, 1000);
            for (int i = 0; i < 20; ++i) {
                const mpq_class x = (good + bad) / 2;
                (sign < 0 ? holds(x, Q) : holds(Q, x)) ? good = x : bad = x;
            }
            for (const auto& x : {good, bad}) print(sign < 0 ? question(x, Q) : question(Q, x));
        }
    }

    /// The step to N, whose place is [a, b], moved by bisection to where it is just allowed.
    void places() {
        const std::uint64_t n = std::array{3, 4, 8, 9, 10, 20, 902}[below(7)];
        const auto verdict = [&](const mpq_class& a, const mpq_class& b) {
            return "places " + bits_ + " " + std::to_string(n) + " " + a.get_str() + " " + b.get_str();
        };
        const auto holds = [&](const mpq_class& a, const mpq_class& b) {
            return law_rows::judged(verdict(a, b)).starts_with("certified");
        };
        const double root = static_cast<double>(n - 2) / 0.88559512945;
        mpq_class middle(root * root);  // C sqrt q = N - 2
        if (n >= 9) middle += mpq_class(root / 1000);
        if (!holds(middle, middle)) return print(verdict(middle, middle));
        for (const int sign : {-1, 1}) {
            mpq_class good = middle, bad = middle + sign * middle / 3;
            for (int i = 0; i < 24; ++i) {
                const mpq_class x = (good + bad) / 2;
                (sign < 0 ? holds(x, middle) : holds(middle, x)) ? good = x : bad = x;
            }
            for (const auto& x : {good, bad}) print(sign < 0 ? verdict(x, middle) : verdict(middle, x));
        }
    }

    std::mt19937_64 random_;
    std::string bits_;
};

}  // namespace

int main(int argc, char** argv) {
    return leaf_rows::near_main(
        argc, argv, [](std::uint64_t seed, int number) { Maker(seed).make(number); }, law_rows::judged);
}
