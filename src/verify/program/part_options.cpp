#include "verify/program/part_options.hpp"

namespace dumbbell_verify {

bool part_option(Words& words, Job& job) {
    if (words.option != "--shards" && words.option != "--combine") return false;
    words.once();
    const std::string value = words.value();
    Settings& settings = job.settings;
    if (words.option == "--combine") {
        job.parts = value;
        settings.check = {};
        settings.demand.keep = all_pieces;
        return true;
    }
    settings.check = settings.demand.keep = parse_pieces(value);
    if (settings.check == Pieces{})
        throw std::invalid_argument("--shards needs the numbers of pieces, such as 5-8 or 5, not `" +
                                    value.substr(0, 60) + "`");
    return true;
}

}  // namespace dumbbell_verify
