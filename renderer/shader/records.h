// The ways in which hit records are kept between passes. Each is a pair of shader files.
#pragma once

#include <string>
#include <vector>

namespace glimt {

struct Record {
  std::string name;
  std::string input_file;             // readRecord()
  std::string output_file;            // writeRecord()
  std::vector<std::string> samplers;  // one for each texture that a record is kept in
  int gles = 2;                       // the least OpenGL ES version that it runs on
};

// "packed": one texel. "wide": three texels, every field a float of its own.
const std::vector<Record>& records();

// Errors: usage, for a record that does not exist.
const Record& recordNamed(const std::string& name);

}  // namespace glimt
