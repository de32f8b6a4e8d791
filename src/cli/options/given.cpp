#include "cli/options/given.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/fields.hpp"

namespace dumbbell::cli {

const Given::Value& Given::value(std::string_view name) const {
    const auto found = std::ranges::find_if(values_, [&](const Value& v) { return v.option->name == name; });
    if (found == values_.end()) {
        throw BrokenInvariant(fmt::format("the command has no option {}", name));
    }
    return *found;
}

const std::vector<std::string>& Given::words(std::string_view name) const { return value(name).words; }

std::string Given::text(std::string_view name) const {
    const Value& v = value(name);
    return v.words.empty() ? std::string(v.option->standard) : v.words.front();
}

long Given::number(std::string_view name) const {
    const auto number = number_of<long>(text(name));
    if (!number) {
        throw BrokenInvariant(fmt::format("{} has no number", name));
    }
    return *number;
}

std::string fault_of(const Option& option, const std::string& value) {
    if (const auto choices = option.choices();
        !choices.empty() && std::ranges::find(choices, value) == choices.end()) {
        return fmt::format("{} not in {{{}}}", value, fmt::join(choices, ","));
    }
    const auto number = option.least < option.most ? number_of<long>(value) : std::optional(option.least);
    if (!number || *number < option.least || *number > option.most) {
        return fmt::format("{} is not from {} to {}", value, option.least, option.most);
    }
    return option.fault == nullptr ? "" : option.fault(value);
}

}  // namespace dumbbell::cli
