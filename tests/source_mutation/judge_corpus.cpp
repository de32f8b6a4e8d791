// Verifies every certificate of a folder and compares with the verdict that its list, verdicts.tsv, expects:
// lines FILE<tab>verified or FILE<tab>rejected. Exit code 1 at the first that differs. What mutation of the
// verifier's source runs first, because it is fast: one process for hundreds of files.
#include <fstream>
#include <iostream>
#include <string>

#include "verify/certificate.hpp"

namespace {

bool verified(const std::string& path, const std::string& scene) {
    dumbbell_verify::Settings settings;
    settings.scene = scene;
    try {
        (void)dumbbell_verify::verify(path, settings);
        return true;
    } catch (const std::exception&) {
        return false;
    }
}

/// The verifier demands the dumbbell unless told otherwise: each certificate is offered as what it says it
/// is.
std::string scene_of(const std::string& path) {
    std::ifstream file(path);
    std::string word;
    for (int words = 0; words < 200 && file >> word; ++words) {
        if (word == "scene" && file >> word) {
            return word;
        }
    }
    return "dumbbell";
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: judge_corpus FOLDER\n";
        return 2;
    }
    const std::string folder = argv[1];
    std::ifstream list(folder + "/verdicts.tsv");
    std::string name, verdict;
    long judged = 0;
    while (std::getline(list, name, '\t') && std::getline(list, verdict)) {
        const std::string path = folder + "/" + name;
        if (verified(path, scene_of(path)) != (verdict == "verified")) {
            std::cout << name << ": not " << verdict << "\n";
            return 1;
        }
        ++judged;
    }
    std::cout << judged << " verdicts as expected\n";
    return judged > 0 ? 0 : 2;
}
