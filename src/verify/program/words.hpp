// The words of a command line, or of a claim in a list, one after the other.
#pragma once
#include <cstdint>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "verify/format/text.hpp"

namespace dumbbell_verify {

/// Takes this character from the beginning of the text, if it is there.
inline bool take(std::string_view& text, char c) {
    if (!text.starts_with(c)) return false;
    text.remove_prefix(1);
    return true;
}

/// Takes the digits with which the text begins.
inline std::string take_digits(std::string_view& text) {
    const std::string digits(text.substr(0, text.find_first_not_of("0123456789")));
    text.remove_prefix(digits.size());
    return digits;
}

/// Options are `--name`, `--name VALUE` or `--name=VALUE`; after `--` there are none. What is wrong is
/// thrown as std::invalid_argument with a message for the user.
class Words {
  public:
    explicit Words(std::vector<std::string> words) : words_(std::move(words)) {}

    std::string word;    ///< the present one as it stands
    std::string option;  ///< the name if it is an option, else empty

    /// On to the next word, if there is one.
    bool next() {
        if (at_ < words_.size() && words_[at_] == "--" && !ended_) ended_ = true, ++at_;
        if (at_ == words_.size()) return false;
        word = words_[at_++];
        option = !ended_ && word.size() > 1 && word[0] == '-' ? word.substr(0, word.find('=')) : "";
        repeated_ = !option.empty() && !seen_.insert(option).second;
        return true;
    }
    /// Was this option among the words so far?
    [[nodiscard]] bool seen(const std::string& name) const { return seen_.contains(name); }
    /// The present option must not have been there before.
    void once() const {
        if (repeated_) throw std::invalid_argument(option + " is given twice");
    }
    /// The value of the present option.
    std::string value() {
        if (word.size() > option.size()) return word.substr(option.size() + 1);
        if (at_ == words_.size()) throw std::invalid_argument("no value after " + option);
        return words_[at_++];
    }
    std::uint64_t number(std::uint64_t least, std::uint64_t most) {
        const std::string text = value();
        if (is_natural(text, 18))
            if (const std::uint64_t n = std::stoull(text); n >= least && n <= most) return n;
        throw std::invalid_argument(option + " needs a number from " + std::to_string(least) + " to " +
                                    std::to_string(most) + ", not `" + text.substr(0, 60) + "`");
    }

    /// A natural number as long as one in a file may be.
    mpz_class count() {
        const std::string text = value();
        if (is_natural(text, longest_integer)) return mpz_class(text);
        throw std::invalid_argument(option + " needs a number of at most 2100 digits, not `" +
                                    text.substr(0, 60) + "`");
    }

    /// A time as `30s`, `10m` or `1.5h`, in units of work.
    std::uint64_t time() {
        const std::string text = value();
        std::string_view rest = text;
        const std::string whole = take_digits(rest);
        const bool has_point = take(rest, '.');
        std::string thousandths = has_point ? take_digits(rest) : "";
        if (whole.empty() || whole.size() > 5 || thousandths.empty() == has_point || thousandths.size() > 3 ||
            (rest != "s" && rest != "m" && rest != "h"))
            throw std::invalid_argument(option + " needs a time such as 30s, 10m or 2h, not `" +
                                        text.substr(0, 60) + "`");
        thousandths.resize(3, '0');
        const std::uint64_t n = std::stoull(whole) * 1000 + std::stoull(thousandths);
        const std::uint64_t seconds = rest == "s" ? 1 : rest == "m" ? 60 : 3600;
        return n * (units_per_second / 1000) * seconds;
    }

  private:
    std::vector<std::string> words_;
    std::set<std::string> seen_;
    std::size_t at_ = 0;
    bool ended_ = false, repeated_ = false;
};

}  // namespace dumbbell_verify
