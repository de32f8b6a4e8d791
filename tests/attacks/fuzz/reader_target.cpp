// Any bytes as a certificate for the program's own reader: they are read, or there is one message for the
// user; what is read can be written, and is the same when it is read again.
#include <algorithm>

#include "base/error.hpp"
#include "collisions/reader.hpp"
#include "collisions/writer.hpp"
#include "file_text.hpp"
#include "scratch.hpp"
#include "target.hpp"

namespace {

using namespace dumbbell_fuzz;
using dumbbell::collisions::Certificate, dumbbell::collisions::Piece;

std::optional<Certificate> read(const std::string& bytes) {
    static MemoryFile file;
    try {
        return dumbbell::collisions::read_certificate(file.holding(bytes));
    } catch (const dumbbell::InputError& error) {
        const std::string message = error.what();
        must(message.find('\n') == std::string::npos, "a message is one line");
        return std::nullopt;
    }
}

/// What the writer demands of pieces, and the reader leaves to others.
bool follow_one_another(const std::vector<Piece>& pieces) {
    const auto broken = [](const Piece& a, const Piece& b) { return a.q_hi != b.q_lo; };
    const auto reversed = [](const Piece& p) { return p.q_lo > p.q_hi; };
    return std::adjacent_find(pieces.begin(), pieces.end(), broken) == pieces.end() &&
           std::none_of(pieces.begin(), pieces.end(), reversed);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes = text_of(data, size);
    if (!plain_text(bytes)) return 0;
    const auto first = read(bytes);
    if (!first || !follow_one_another(first->pieces)) return 0;
    const std::string text = dumbbell::collisions::render(*first).text;
    const auto second = read(text);
    must(second.has_value(), "what was written can be read");
    must(dumbbell::collisions::render(*second).text == text, "reading and writing again changes nothing");
    return 0;
}
