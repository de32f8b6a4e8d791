#include "mutations.hpp"
#include "rooms/verify/core/make_certificate.hpp"

namespace dumbbell_mutation {
namespace {

std::string flipped(std::string text, std::size_t byte, int bits) {
    text[byte] = static_cast<char>(static_cast<unsigned char>(text[byte]) ^ bits);
    return text;
}
std::string at_byte(std::size_t i) { return "byte " + std::to_string(i); }

void of_text(const std::string& text, const Sink& sink) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        sink({"cut off", at_byte(i), text.substr(0, i)});
        sink({"cut off", at_byte(i) + ", as it is", text.substr(0, i), true});
        for (const int bits : {1, 4}) sink({"bit changed", at_byte(i), flipped(text, i, bits)});
        if (i % 16 == 0) sink({"bit changed", at_byte(i), flipped(text, i, 128)});
    }
}

void of_compressed(const std::string& text, const Sink& sink) {
    const std::string bytes = make::gzipped(text);
    sink({"compressed", "whole", bytes, true});
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        sink({"compressed, cut off", at_byte(i), bytes.substr(0, i), true});
        for (const int bits : {1, 64})
            sink({"compressed, bit changed", at_byte(i), flipped(bytes, i, bits), true});
    }
    sink({"compressed, more behind", "twice", bytes + bytes, true});
    sink({"compressed, more behind", "an empty member", bytes + make::gzipped(""), true});
    sink({"compressed, more behind", "zeros", bytes + std::string(512, '\0'), true});
    sink({"compressed, more behind", "compressed twice", make::gzipped(bytes), true});
    const std::size_t half = text.size() / 2;
    sink({"compressed, more behind", "two members",
          make::gzipped(text.substr(0, half)) + make::gzipped(text.substr(half)), true});
}

}  // namespace

void byte_mutations(const std::string& text, const Sink& sink) {
    of_text(text, sink);
    of_compressed(text, sink);
    for (const char behind : {'\n', ' ', 'x', '\0'})
        sink({"more behind", "byte " + std::to_string(behind), text + behind, true});
    sink({"more behind", "itself", text + text, true});
    sink({"bytes before", "mark of UTF-8", "\xef\xbb\xbf" + text, true});
    sink({"bytes before", "line feed", "\n" + text, true});
    sink({"cut off", "to nothing", "", true});
}

}  // namespace dumbbell_mutation
