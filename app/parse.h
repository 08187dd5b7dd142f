// From an argument's text to a value. Errors: usage, naming the option and what it takes.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "renderer/core/vector.h"

namespace glimt {

std::int64_t parseInteger(const std::string& option, const std::string& text, std::int64_t least,
                          std::int64_t most);

// A finite number.
double parseNumber(const std::string& option, const std::string& text);

// A number above `low` and below `high`.
double parseNumberBetween(const std::string& option, const std::string& text, double low,
                          double high);

// Percent, from 0.001 to 100, with or without a "%".
double parsePercent(const std::string& option, const std::string& text);

// "WxH", pixels.
std::array<int, 2> parseSize(const std::string& option, const std::string& text);

// "FIRST:COUNT", FIRST from 0 and COUNT from 1 on.
std::array<int, 2> parseSamples(const std::string& option, const std::string& text);

// Different names, with commas between them.
std::vector<std::string> parseNames(const std::string& option, const std::string& text);

// Some of `choices`, with commas between them, or "all".
std::vector<std::string> parseChoices(const std::string& option, const std::string& text,
                                      const std::vector<std::string>& choices);

// "I/N", from 1/1 on, I being at most N.
std::array<int, 2> parsePart(const std::string& option, const std::string& text);

// "X,Y,Z".
glm::dvec3 parseVector(const std::string& option, const std::string& text);

// One of `choices`.
std::string parseChoice(const std::string& option, const std::string& text,
                        const std::vector<std::string>& choices);

}  // namespace glimt
