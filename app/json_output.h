// Reports for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "renderer/core/vector.h"

namespace glimt {

// Keys come out in the order in which they were put in.
using Json = nlohmann::ordered_json;

// A float with the digits that it needs, and not those of the double nearest to it.
Json jsonOf(float value);
Json jsonOf(const Vec3& vector);

// The value of --json is a file, "-" for standard output, or empty where no report was asked for.
// Finds out early that the file cannot be written. Errors: usage.
void checkJsonFile(const std::string& file);

// Errors: failed.
void writeJson(const std::string& file, const Json& json);

// Writes to standard output. Errors: failed.
void writeOut(const std::string& text);

}  // namespace glimt
