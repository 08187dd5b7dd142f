// What a folder of a batch holds: manifest.json. It says what is up to date, and so where an
// interrupted job goes on.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace glimt {

// One file.
struct ManifestEntry {
  std::string file;  // in the folder
  std::string variant;
  std::string camera;
  std::optional<double> angle;
  std::array<int, 2> size{};
  int samples = 0;
  std::optional<double> noise;  // below this with 95% confidence, as a share of 1
  double seconds = 0;           // of sampling
  std::string sha256;           // of the file
  std::string inputs;           // SHA-256 of what the picture depends on
  bool denoised = false;        // the file; the noise is that of its samples
};

struct ManifestFailure {
  std::string file;
  std::string error;
};

// In whatever order it is filled in; it is written in the order of the files' names.
class Manifest {
 public:
  const std::vector<ManifestEntry>& entries() const { return entries_; }
  const std::vector<ManifestFailure>& failures() const { return failures_; }

  // Null where there is none.
  const ManifestEntry* find(const std::string& file) const;

  // In place of what there is about the same file.
  void add(const ManifestEntry& entry);
  void add(const ManifestFailure& failure);

  // Forgets all files but these.
  void keepOnly(const std::vector<std::string>& files);

 private:
  std::vector<ManifestEntry> entries_;
  std::vector<ManifestFailure> failures_;
};

// The manifest's name where process `part` of `parts` writes one of its own.
std::string manifestName(int part, int parts);

// Of the whole folder: the manifest and those of its parts, as far as they are there. Errors:
// input, for one that cannot be read.
Manifest readManifests(const std::filesystem::path& folder);

// Whole or not at all. Errors: failed.
void writeManifest(const std::filesystem::path& file, const Manifest& manifest);

// Once the manifest holds what they hold.
void removePartManifests(const std::filesystem::path& folder);

}  // namespace glimt
