#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/options/option.hpp"

namespace dumbbell::cli {

/// The options of a command, as they were given. Each is asked for by its name (the last, if it has several);
/// one that the command does not have is a BrokenInvariant.
class Given {
  public:
    struct Value {
        const Option* option;
        std::vector<std::string> words;  ///< empty: not given; of a flag one word
    };

    void add(const Option& option, std::vector<std::string> words) {
        values_.push_back({&option, std::move(words)});
    }
    [[nodiscard]] const std::vector<Value>& values() const { return values_; }

    /// Is it on the command line?
    [[nodiscard]] bool has(std::string_view name) const { return !words(name).empty(); }
    [[nodiscard]] const std::vector<std::string>& words(std::string_view name) const;
    /// Its value, or its standard value, which may be empty.
    [[nodiscard]] std::string text(std::string_view name) const;
    /// Precondition: its value, or its standard value, is a number.
    [[nodiscard]] long number(std::string_view name) const;

  private:
    [[nodiscard]] const Value& value(std::string_view name) const;

    std::vector<Value> values_;
};

/// What is wrong with the value of an option, empty if nothing is.
[[nodiscard]] std::string fault_of(const Option& option, const std::string& value);

}  // namespace dumbbell::cli
