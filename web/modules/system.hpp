// What both modules have of a system, and how the page calls them: it writes words or bytes into `room`, and
// reads the answer, JSON with a zero byte behind it.
#pragma once
#include <string>
#include <vector>

extern std::string room;

/// The room's lines.
std::vector<std::string> words_given();

/// Keeps the answer. Call it once, with a function that makes it.
const char* answered(std::string (*make)());
