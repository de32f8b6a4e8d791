// A certificate cut into several, for tests.
#pragma once
#include <random>

#include "rooms/verify/core/make_certificate.hpp"
#include "shipped.hpp"

namespace make {

/// Of a text about mass ratios: the lines before `ratio`, and each piece.
struct Cuttable {
    std::string head;
    std::vector<std::string> pieces;

    explicit Cuttable(const std::string& text) : head(text.substr(0, text.find("ratio "))) {
        for (std::size_t at = text.find("\npiece ") + 1; text.compare(at, 6, "piece ") == 0;) {
            const std::size_t end = std::min(text.find("\npiece ", at), text.find("\ntotal ", at)) + 1;
            pieces.push_back(text.substr(at, end - at));
            at = end;
        }
    }
    /// A certificate of the pieces from number `first` on, counted from 0.
    [[nodiscard]] std::string with(std::size_t first, std::size_t many) const {
        const auto ends = [](const std::string& piece) {
            std::istringstream words(piece);
            std::string word, lo, hi;
            words >> word >> lo >> hi;
            return std::pair(lo, hi);
        };
        std::string text = head + "ratio " + ends(pieces[first]).first + " " +
                           ends(pieces[first + many - 1]).second + "\npieces " + std::to_string(many) + "\n";
        for (std::size_t i = first; i < first + many; ++i) text += pieces[i];
        return closed(text);
    }
    /// Certificates of all pieces, cut at random places.
    [[nodiscard]] std::vector<std::string> at_random(std::mt19937& random) const {
        std::vector<std::string> files;
        const std::size_t longest = 1 + random() % pieces.size();
        for (std::size_t first = 0, many = 0; first < pieces.size(); first += many) {
            many = std::min(pieces.size() - first, 1 + random() % longest);
            files.push_back(with(first, many));
        }
        return files;
    }
};

}  // namespace make
