// Small glTF files for tests: their JSON, and a buffer that grows with what is put into it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace glimt {

inline std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = word << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : kDigits[word >> (18 - 6 * k) & 63];
  }
  return text;
}

template <typename T>
std::string bytesOf(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

class GltfText {
 public:
  using Json = nlohmann::json;

  Json root = {{"asset", {{"version", "2.0"}}}};

  int view(std::string_view bytes, int stride = 0) {
    buffer_.resize((buffer_.size() + 3) / 4 * 4);
    Json view = {{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}};
    if (stride > 0) view["byteStride"] = stride;
    buffer_ += bytes;
    return append("bufferViews", view);
  }

  // All elements of a view.
  int accessor(int view, int component_type, std::size_t count, const char* type) {
    return append("accessors", {{"bufferView", view},
                                {"componentType", component_type},
                                {"count", count},
                                {"type", type}});
  }

  // Of floats; `components` of them are one element.
  int floats(const std::vector<float>& values, const char* type, std::size_t components) {
    return accessor(view(bytesOf(values)), 5126, values.size() / components, type);
  }

  int shorts(const std::vector<std::uint16_t>& indices) {
    return accessor(view(bytesOf(indices)), 5123, indices.size(), "SCALAR");
  }

  int append(const char* key, const Json& value) {
    root[key].push_back(value);
    return static_cast<int>(root[key].size()) - 1;
  }

  // A mesh of one primitive.
  int mesh(const Json& primitive) { return append("meshes", {{"primitives", {primitive}}}); }

  // A mesh of one triangle in the plane z = 0, its front towards +z.
  int triangle(const Json& more = Json::object()) {
    Json primitive = more;
    primitive["attributes"]["POSITION"] = floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", 3);
    return mesh(primitive);
  }

  std::string text() const {
    Json whole = root;
    if (!buffer_.empty()) {
      whole["buffers"].push_back(
          {{"byteLength", buffer_.size()},
           {"uri", "data:application/octet-stream;base64," + base64(buffer_)}});
    }
    return whole.dump();
  }

  const std::string& buffer() const { return buffer_; }

 private:
  std::string buffer_;
};

// The same as a .glb.
inline std::string asGlb(const GltfText& gltf) {
  const auto number = [](std::size_t value) {
    return bytesOf(std::vector{static_cast<std::uint32_t>(value)});
  };
  GltfText::Json root = gltf.root;
  root["buffers"].push_back({{"byteLength", gltf.buffer().size()}});
  std::string json = root.dump();
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string binary = gltf.buffer();
  binary.resize((binary.size() + 3) / 4 * 4);
  return "glTF" + number(2) + number(28 + json.size() + binary.size()) + number(json.size()) +
         "JSON" + json + number(binary.size()) + std::string("BIN\0", 4) + binary;
}

}  // namespace glimt
