#include <array>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

#include "catch.hpp"
#include "dumbbell/certify.hpp"
#include "dumbbell/critical.hpp"
#include "dumbbell/error.hpp"
#include "dumbbell/law.hpp"
#include "dumbbell/trace.hpp"
#include "dumbbell/verify.hpp"

using namespace dumbbell::api;

namespace {

/// What stands behind the function: what it is about, and options by their names.
struct Question {
    std::string subject, demand;
    std::map<std::string, std::string> options;

    explicit Question(std::istream& words) {
        std::string last;
        for (std::string word; words >> word;) {
            if (word.starts_with("--")) {
                options[last = word.substr(2)];
                demand += word + " ";
            } else {
                (last.empty() ? subject : options[last]) = word;
                demand += last.empty() ? "" : word + " ";
            }
        }
    }
    [[nodiscard]] std::string option(const std::string& name, const std::string& usual = "") const {
        return options.contains(name) ? options.at(name) : usual;
    }
};

Proof certified(const Question& asked) {
    const std::map<std::string, Section> sections{
        {"", Section::turning}, {"full", Section::full}, {"plain", Section::plain}};
    const CertifyOptions options{.gap = asked.option("gap", "1e-6"),
                                 .section = sections.at(asked.option("section"))};
    if (asked.options.contains("coin")) {
        return certify(Body{"1", "4"}, options);
    }
    if (asked.options.contains("rho")) {
        return certify(Body{asked.option("rho"), asked.option("inertia")}, options);
    }
    const MassRatio ratio(asked.subject);
    return asked.options.contains("rod-mass") ? certify(body_of_rod(ratio, asked.option("rod-mass")), options)
                                              : certify(ratio, options);
}

std::string answer(const std::string& function, const Question& asked) try {
    if (function == "certify") {
        return certified(asked).sha256.substr(0, 16);
    }
    if (function == "verify") {
        constexpr std::array verdicts{"verified", "rejected", "unsupported", "unreadable", "limit", "open"};
        const Claim claim{.kind = "", .demand = asked.demand};
        const Verification found = verify(DUMBBELL_CERTIFICATES "/" + asked.subject, claim);
        return verdicts.at(static_cast<std::size_t>(found.verdict));
    }
    if (function == "critical") {
        return critical(std::stol(asked.subject), {.digits = std::stoi(asked.option("digits"))})->digits;
    }
    const MassRatio ratio(asked.subject);
    if (function == "law") {
        const Law found = law(ratio);
        return found.least + " " + found.most;
    }
    const Trace found =
        trace(ratio, {asked.option("phi"), asked.option("phidot"), asked.option("y"), asked.option("ydot")});
    return std::to_string(found.least) + " " + (found.most ? std::to_string(*found.most) : "None");
} catch (const InputError&) {
    return "refused";
} catch (const std::invalid_argument&) {
    return "refused";
}

}  // namespace

TEST_CASE("The library answers as the programs do") {
    std::ifstream table(DUMBBELL_QUESTIONS);
    int asked = 0;
    for (std::string line; std::getline(table, line);) {
        if (!line.starts_with('#')) {
            const std::size_t tab = line.find('\t');
            std::istringstream words(line.substr(0, tab));
            std::string function;
            words >> function;
            CAPTURE(line);
            CHECK(answer(function, Question(words)) == line.substr(tab + 1));
            ++asked;
        }
    }
    CHECK(asked > 40);
}
