#include "file/sealed_lines.hpp"

#include "base/error.hpp"
#include "base/fields.hpp"
#include "file/lines.hpp"

namespace dumbbell {

void SealedLines::head(const Generator& generator, std::string_view lemmas, std::string_view scene,
                       std::string_view section, std::string_view claim) {
    line("dumbbell-certificate 1");
    line("generator {} {}", generator.program, generator.version);
    line("lemmas {}", lemmas);
    line("scene {}", scene);
    line("section {}", section);
    line("claim {}", claim);
}

SealedReader::SealedReader(std::string_view text, std::string_view what) : what_(what) {
    const auto lines = sealed_lines(text);
    if (!lines) {
        fail();
    }
    rest_ = *lines;
}

void SealedReader::fail() const {
    throw InputError(
        fmt::format("this is not {}, or a damaged one: it has been changed, or is incomplete", what_));
}

std::string_view SealedReader::ahead() const { return rest_.substr(0, rest_.find('\n')); }

std::string_view SealedReader::line() {
    const std::size_t end = rest_.find('\n');
    if (end == std::string_view::npos) {
        fail();
    }
    const std::string_view found = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return found;
}

std::string_view SealedReader::value(std::string_view keyword) {
    std::string_view found = line();
    if (!found.starts_with(keyword) || found.size() <= keyword.size() || found[keyword.size()] != ' ') {
        fail();
    }
    found.remove_prefix(keyword.size() + 1);
    return found;
}

std::size_t SealedReader::number(std::string_view keyword) { return parse_size(value(keyword)); }

void SealedReader::end() const {
    if (!rest_.empty()) {
        fail();
    }
}

std::size_t parse_size(std::string_view word) {
    const auto number = number_of<std::size_t>(word);
    if (!number || *number >= 1'000'000'000'000'000) {
        throw InputError(fmt::format("'{}' is not a number below 10^15", word.substr(0, 40)));
    }
    return *number;
}

}  // namespace dumbbell
