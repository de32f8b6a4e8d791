#include "verify/program/junit.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

#include "verify/program/escape.hpp"
#include "verify/program/examine.hpp"

namespace dumbbell_verify {
namespace {

std::string attribute(const std::string& name, const std::string& value) {
    return " " + name + "=\"" + xml_text(value) + "\"";
}

std::string decimal(double seconds) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.3f", seconds);
    return text.data();
}

std::string timestamp(std::time_t time) {
    std::tm utc{};
    std::array<char, 40> text{};
    if (::gmtime_r(&time, &utc)) std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%S", &utc);
    return text.data();
}

std::string element(const TestCase& test) {
    const std::string start = "    <testcase" + attribute("name", test.name) +
                              attribute("classname", "dumbbell-verify") +
                              attribute("time", decimal(test.seconds));
    if (exit_code(test.verdict) == 0) return start + "/>\n";
    const std::string kind = test.verdict == Verdict::rejected ? "failure" : "error";
    return start + ">\n      <" + kind + attribute("type", verdict_name(test.verdict)) +
           attribute("message", test.reason) + ">" + xml_text(test.output) + "</" + kind +
           ">\n    </testcase>\n";
}

}  // namespace

std::string junit(const std::vector<TestCase>& cases, std::time_t started, double seconds) {
    const auto count = [&](auto is) {
        return std::to_string(
            std::count_if(cases.begin(), cases.end(), [&](const TestCase& c) { return is(c.verdict); }));
    };
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n  <testsuite";
    text +=
        attribute("name", "dumbbell-verify") + attribute("package", "dumbbell-verify") +
        attribute("id", "0") + attribute("timestamp", timestamp(started)) +
        attribute("hostname", "localhost") + attribute("tests", std::to_string(cases.size())) +
        attribute("failures", count([](Verdict v) { return v == Verdict::rejected; })) +
        attribute("errors", count([](Verdict v) { return v != Verdict::rejected && exit_code(v) != 0; })) +
        attribute("time", decimal(seconds)) + ">\n    <properties/>\n";
    std::string output;
    for (const TestCase& test : cases) {
        text += element(test);
        output += test.output + "\n";
    }
    return text + "    <system-out>" + xml_text(output) +
           "</system-out>\n    <system-err/>\n  </testsuite>\n</testsuites>\n";
}

}  // namespace dumbbell_verify
