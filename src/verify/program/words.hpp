// The words of a command line, or of a claim in a list, one after the other.
#pragma once
#include <cstdint>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "verify/format/text.hpp"

namespace dumbbell_verify {

/// Options are `--name`, `--name VALUE` or `--name=VALUE`; behind `--` there are none. What is wrong is
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
        if (at_ == words_.size()) throw std::invalid_argument("no value behind " + option);
        return words_[at_++];
    }
    std::uint64_t number(std::uint64_t least, std::uint64_t most) {
        const std::string text = value();
        if (is_natural(text, 18))
            if (const std::uint64_t n = std::stoull(text); n >= least && n <= most) return n;
        throw std::invalid_argument(option + " needs a number from " + std::to_string(least) + " to " +
                                    std::to_string(most) + ", not `" + text.substr(0, 60) + "`");
    }

    /// A time as `30s`, `10m` or `1.5h`, in units of work.
    std::uint64_t time() {
        static const std::regex form("([0-9]{1,5})(?:\\.([0-9]{1,3}))?([smh])");
        const std::string text = value();
        std::smatch part;
        if (!std::regex_match(text, part, form))
            throw std::invalid_argument(option + " needs a time such as 30s, 10m or 2h, not `" +
                                        text.substr(0, 60) + "`");
        const std::string thousandths = part.str(2) + std::string(3 - part.length(2), '0');
        const std::uint64_t n = std::stoull(part.str(1)) * 1000 + std::stoull(thousandths);
        const std::uint64_t seconds = part.str(3) == "s" ? 1 : part.str(3) == "m" ? 60 : 3600;
        return n * (units_per_second / 1000) * seconds;
    }

  private:
    std::vector<std::string> words_;
    std::set<std::string> seen_;
    std::size_t at_ = 0;
    bool ended_ = false, repeated_ = false;
};

}  // namespace dumbbell_verify
