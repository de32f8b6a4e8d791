// How libFuzzer changes certificate files: like any bytes, or the text inside gzip, or whole lines; mostly
// with a trailer that fits again, so that the checksum does not hide what comes after it.
#include <algorithm>
#include <random>
#include <sstream>
#include <vector>

#include "file_text.hpp"
#include "rooms/verify/core/make_certificate.hpp"
#include "target.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed);

namespace {

using namespace dumbbell_fuzz;
using Lines = std::vector<std::string>;

/// libFuzzer's own mutations, of the part [begin, end) of the text.
std::string changed(const std::string& text, std::size_t begin, std::size_t end, std::size_t most) {
    const std::size_t room = std::max<std::size_t>(most > text.size() ? most - text.size() : 0, 1);
    std::string part = text.substr(begin, end - begin);
    const std::size_t size = part.size();
    part.resize(size + room);
    part.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(part.data()), size, part.size()));
    return text.substr(0, begin) + part + text.substr(end);
}

Lines lines_of(const std::string& text) {
    Lines lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line + '\n');
    return lines;
}

/// One line deleted, doubled, moved, or changed in itself.
std::string with_changed_lines(const std::string& text, std::size_t most, std::minstd_rand& random) {
    Lines lines = lines_of(text);
    if (lines.empty()) return text;
    const auto any = [&] { return lines.begin() + static_cast<std::ptrdiff_t>(random() % lines.size()); };
    const auto line = any();
    switch (random() % 5) {
        case 0:
            lines.erase(line);
            break;
        case 1: {
            const std::string copy = *line;
            lines.insert(any(), copy);
            break;
        }
        case 2:
            std::iter_swap(line, any());
            break;
        default: {
            const std::size_t space = std::min(line->find(' '), line->size() - 1);
            *line = changed(*line, random() % 4 == 0 ? 0 : space, line->size() - 1, most);
        }
    }
    std::string result;
    for (const std::string& l : lines) result += l;
    return result;
}

}  // namespace

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
    std::minstd_rand random(seed);
    const std::string bytes = text_of(data, size);
    const bool packed = is_gzip(bytes);
    const auto text = plain_text(bytes);
    if (!text || random() % 8 == 0) return LLVMFuzzerMutate(data, size, most);
    std::string result = random() % 2 == 0
                             ? changed(*text, 0, std::min(text->find("\ntotal "), text->size()), most)
                             : with_changed_lines(*text, most, random);
    if (random() % 8 != 0) result = with_fitting_trailer(result);
    if (packed ? random() % 8 != 0 : random() % 32 == 0) result = make::gzipped(result);
    const std::size_t end = std::min(result.size(), most);
    std::copy_n(result.begin(), end, data);
    return end;
}
