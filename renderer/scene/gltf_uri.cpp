#include "renderer/scene/gltf_uri.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <charconv>

#include "renderer/core/error.h"
#include "renderer/core/file.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

namespace fs = std::filesystem;

// "%20" as a blank.
std::string percentDecoded(const std::string& uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned char byte = 0;
    const char* const digits = uri.data() + i + 1;
    if (uri[i] == '%' && i + 2 < uri.size() &&
        std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
      text += static_cast<char>(byte);
      i += 2;
    } else {
      text += uri[i];
    }
  }
  return text;
}

bool hasScheme(const std::string& uri) {
  const std::size_t colon = uri.find(':');
  return colon != std::string::npos && colon < uri.find('/') && colon > 0;
}

// A file from anyone may name any other file of the computer.
bool leavesFolder(const fs::path& relative) {
  const fs::path normal = relative.lexically_normal();
  return relative.empty() || relative.is_absolute() || normal.empty() || *normal.begin() == "..";
}

}  // namespace

std::string readGltfUri(const fs::path& model, const std::string& uri, const std::string& who,
                        std::uintmax_t largest) {
  const auto fail = [&](const std::string& what) {
    throw Error(ErrorKind::input, fmt::format("{}: {} {}", printable(model.string()), who, what));
  };
  if (uri.starts_with("data:")) {
    std::vector<unsigned char> bytes;
    std::string kind;
    if (!tinygltf::IsDataURI(uri) || !tinygltf::DecodeDataURI(&bytes, kind, uri, 0, false))
      fail("has a data URI of a kind that glimt does not read; store it as a file");
    if (bytes.size() > largest)
      fail(fmt::format("has more than {} bytes; make it smaller", grouped(largest)));
    return {bytes.begin(), bytes.end()};
  }
  const std::string shown = printable(std::string_view(uri).substr(0, 200));
  if (hasScheme(uri))
    fail(fmt::format("is at '{}', which glimt does not fetch; put the file beside the model",
                     shown));
  const std::string name = percentDecoded(uri);
  if (name.find('\0') != std::string::npos || leavesFolder(name))
    fail(fmt::format("is at '{}', outside the model's folder; put the file beside the model",
                     shown));
  try {
    return readFile(model.parent_path() / fs::path(name), largest);
  } catch (const Error& error) {
    fail(fmt::format("is missing: {}", error.what()));
  }
  return {};
}

}  // namespace glimt
