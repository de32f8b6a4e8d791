// The words of a command line, or of a claim in a list, one after the other.
#pragma once
#include <cstdint>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "verify/core/text.hpp"
#include "verify/machine/integer.hpp"

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

/// What [0-9]+(.[0-9]+)?([eE][+-]?[0-9]+)? or 10^[+-]?[0-9]+ stands for, whose exponent has at most four
/// digits behind zeros; nothing of other texts.
inline std::optional<mpq_class> parse_decimal(const std::string& text) {
    std::string_view rest = text;
    std::string digits = take_digits(rest), places, exponent = "0";
    bool fits = !digits.empty(), is_small = false;
    const bool is_power = digits == "10" && take(rest, '^');
    if (is_power) {
        digits = "1";
    } else if (take(rest, '.')) {
        places = take_digits(rest);
        fits = fits && !places.empty();
    }
    if (is_power || take(rest, 'e') || take(rest, 'E')) {
        is_small = take(rest, '-');
        if (!is_small) take(rest, '+');
        exponent = take_digits(rest);
        fits = fits && !exponent.empty();
        exponent.erase(0, exponent.find_first_not_of('0'));
        fits = fits && exponent.size() <= 4;
    }
    if (!fits || !rest.empty()) return std::nullopt;
    const unsigned long tens = exponent.empty() ? 0 : std::stoul(exponent);
    if (tens > 1000) throw std::invalid_argument("an exponent beyond 1000: " + text.substr(0, 60));
    mpz_class top(digits + places, 10), bottom, power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, tens);
    mpz_ui_pow_ui(bottom.get_mpz_t(), 10, places.size());
    (is_small ? bottom : top) *= power;
    mpq_class number(top, bottom);
    number.canonicalize();
    return number;
}

/// A decimal as above, or [0-9]+/[0-9]+ with a denominator that is not 0; nothing of other texts, and of
/// those that are too long.
inline std::optional<mpq_class> parse_rational(const std::string& text) {
    if (text.size() > 2100) return std::nullopt;
    std::string_view rest = text;
    const std::string top = take_digits(rest);
    if (!take(rest, '/')) return parse_decimal(text);
    const std::string bottom = take_digits(rest);
    if (top.empty() || !rest.empty() || bottom.find_first_not_of('0') == std::string::npos)
        return std::nullopt;
    mpq_class number(mpz_class(top, 10), mpz_class(bottom, 10));
    number.canonicalize();
    return number;
}

/// Options are `--name`, `--name VALUE` or `--name=VALUE`; after `--` there are none. What is wrong is
/// thrown as std::invalid_argument with a message for the user.
class Arguments {
  public:
    explicit Arguments(std::vector<std::string> words) : words_(std::move(words)) {}

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

    /// A time as `30s`, `10m` or `1.5h`, in units of work; 2^63 stand for more.
    std::uint64_t time() {
        const std::string text = value();
        const char unit = text.empty() ? ' ' : text.back();
        const int seconds = unit == 's' ? 1 : unit == 'm' ? 60 : unit == 'h' ? 3600 : 0;
        const auto number = seconds == 0 || text.size() > 1000
                                ? std::nullopt
                                : parse_decimal(text.substr(0, text.size() - 1));
        if (!number)
            throw std::invalid_argument(option + " needs a time such as 30s, 10m or 2h, not `" +
                                        text.substr(0, 60) + "`");
        const mpq_class units = *number * seconds * integer(units_per_second);
        const mpz_class whole = units.get_num() / units.get_den();
        return fits(whole, 63) ? unsigned_64(whole) : std::uint64_t{1} << 63;
    }

  private:
    std::vector<std::string> words_;
    std::set<std::string> seen_;
    std::size_t at_ = 0;
    bool ended_ = false, repeated_ = false;
};

}  // namespace dumbbell_verify
