#include "renderer/scene/gltf_accessor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "renderer/core/wording.h"

namespace glimt {
namespace {

constexpr std::size_t kMostIndices = 1 << 25;

std::size_t sizeOf(int component_type) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

// Of a scalar or vector; 0 for what is neither.
int componentsOf(int type) {
  if (type == TINYGLTF_TYPE_SCALAR) return 1;
  return type >= TINYGLTF_TYPE_VEC2 && type <= TINYGLTF_TYPE_VEC4 ? type : 0;
}

// Little-endian, as the file and the machine are; at any alignment.
template <typename T>
T load(const char* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

template <typename T>
float asFloat(const char* at, bool normalized) {
  const auto value = static_cast<float>(load<T>(at));
  if (!normalized) return value;
  return std::max(value / static_cast<float>(std::numeric_limits<T>::max()), -1.0f);
}

// Where the elements of an accessor are.
class Elements {
 public:
  // `stride` 0: one behind the other.
  Elements(std::string_view bytes, std::size_t stride, int component_type, int components)
      : bytes_(bytes),
        component_size_(sizeOf(component_type)),
        size_(component_size_ * static_cast<std::size_t>(components)),
        stride_(stride == 0 ? size_ : stride),
        component_type_(component_type),
        components_(components) {}

  bool holds(std::size_t offset, std::size_t count) const {
    if (size_ == 0 || count == 0 || offset > bytes_.size()) return false;
    const std::size_t room = bytes_.size() - offset;
    return room >= size_ && (count - 1) <= (room - size_) / stride_;
  }
  void startAt(std::size_t offset) { bytes_.remove_prefix(offset); }

  Vec4 vector(std::size_t element, bool normalized) const {
    Vec4 value(0, 0, 0, 1);
    const char* at = bytes_.data() + element * stride_;
    for (int c = 0; c < components_; ++c, at += component_size_) value[c] = number(at, normalized);
    return value;
  }

  std::uint32_t index(std::size_t element) const {
    const char* const at = bytes_.data() + element * stride_;
    if (component_size_ == 1) return load<std::uint8_t>(at);
    return component_size_ == 2 ? load<std::uint16_t>(at) : load<std::uint32_t>(at);
  }

 private:
  float number(const char* at, bool normalized) const {
    switch (component_type_) {
      case TINYGLTF_COMPONENT_TYPE_BYTE:
        return asFloat<std::int8_t>(at, normalized);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return asFloat<std::uint8_t>(at, normalized);
      case TINYGLTF_COMPONENT_TYPE_SHORT:
        return asFloat<std::int16_t>(at, normalized);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return asFloat<std::uint16_t>(at, normalized);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return asFloat<std::uint32_t>(at, normalized);
      default:
        return load<float>(at);
    }
  }

  std::string_view bytes_;
  std::size_t component_size_;
  std::size_t size_;
  std::size_t stride_;
  int component_type_;
  int components_;
};

// One accessor, for as long as it is read.
class Reader {
 public:
  Reader(const GltfDocument& document, int index, std::size_t most, const std::string& who)
      : document_(document), who_(who) {
    const auto& accessors = document.model.accessors;
    if (index < 0 || static_cast<std::size_t>(index) >= accessors.size())
      document.fail(fmt::format("{} uses accessor {}, but the file has {}; export the model again",
                                who, index, accessors.size()));
    accessor_ = &accessors[static_cast<std::size_t>(index)];
    if (sizeOf(accessor_->componentType) == 0 || componentsOf(accessor_->type) == 0)
      fail("is of a type that it cannot have");
    if (accessor_->count == 0) fail("has no elements");
    if (accessor_->count > most)
      document.fail(fmt::format("{} has {} elements; at most {} are read", who,
                                grouped(accessor_->count), grouped(most)));
  }

  const tinygltf::Accessor& accessor() const { return *accessor_; }
  int components() const { return componentsOf(accessor_->type); }

  [[noreturn]] void fail(const char* what) const {
    document_.fail(fmt::format("{} {}; export the model again", who_, what));
  }

  Elements elements() const {
    const tinygltf::Accessor& a = *accessor_;
    return inView(a.bufferView, a.byteOffset, a.count, a.componentType, components(), true);
  }

  // Calls take(element, values, i) for each element that another value takes the place of.
  template <typename Take>
  void replaceSparse(Take&& take) const {
    const auto& sparse = accessor_->sparse;
    if (!sparse.isSparse) return;
    const auto count = static_cast<std::size_t>(std::max(sparse.count, 0));
    const int type = sparse.indices.componentType;
    if (count == 0 || count > accessor_->count || sparse.indices.byteOffset < 0 ||
        sparse.values.byteOffset < 0 || !isIndexType(type))
      fail("has sparse values that are not in order");
    const Elements indices =
        inView(sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset),
               count, type, 1, false);
    const Elements values =
        inView(sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset), count,
               accessor_->componentType, components(), false);
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t element = indices.index(i);
      if (element >= accessor_->count) fail("has a sparse value for an element that is not there");
      take(element, values, i);
    }
  }

  static bool isIndexType(int type) {
    return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
           type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  }

 private:
  Elements inView(int view, std::size_t offset, std::size_t count, int component_type,
                  int components, bool strided) const {
    const std::string_view bytes = document_.bytesOf(view, who_);
    const std::size_t stride =
        strided ? document_.model.bufferViews[static_cast<std::size_t>(view)].byteStride : 0;
    const std::size_t size = sizeOf(component_type) * static_cast<std::size_t>(components);
    if (stride != 0 && stride < size) fail("has elements that overlap");
    Elements elements(bytes, stride, component_type, components);
    if (!elements.holds(offset, count)) fail("reaches beyond its buffer view");
    elements.startAt(offset);
    return elements;
  }

  const GltfDocument& document_;
  const std::string& who_;
  const tinygltf::Accessor* accessor_ = nullptr;
};

}  // namespace

std::vector<Vec4> readGltfVectors(const GltfDocument& document, int accessor, int fewest, int most,
                                  const std::string& who) {
  const Reader reader(document, accessor, kMostGltfVertices, who);
  if (reader.components() < fewest || reader.components() > most)
    reader.fail("has elements of another number of components than it must have");
  const bool normalized = reader.accessor().normalized;
  std::vector<Vec4> values;
  // Without a buffer view all elements are zero, and sparse ones take their place.
  if (reader.accessor().bufferView < 0) {
    values.assign(reader.accessor().count, Vec4(0, 0, 0, reader.components() == 4 ? 0 : 1));
  } else {
    const Elements elements = reader.elements();
    values.reserve(reader.accessor().count);
    for (std::size_t i = 0; i < reader.accessor().count; ++i)
      values.push_back(elements.vector(i, normalized));
  }
  reader.replaceSparse([&](std::uint32_t element, const Elements& replacing, std::size_t i) {
    values[element] = replacing.vector(i, normalized);
  });
  return values;
}

std::vector<std::uint32_t> readGltfIndices(const GltfDocument& document, int accessor,
                                           const std::string& who) {
  const Reader reader(document, accessor, kMostIndices, who);
  if (reader.components() != 1 || !Reader::isIndexType(reader.accessor().componentType))
    reader.fail("must be unsigned integers");
  const Elements elements = reader.elements();
  std::vector<std::uint32_t> indices;
  indices.reserve(reader.accessor().count);
  for (std::size_t i = 0; i < reader.accessor().count; ++i) indices.push_back(elements.index(i));
  reader.replaceSparse([&](std::uint32_t element, const Elements& replacing, std::size_t i) {
    indices[element] = replacing.index(i);
  });
  return indices;
}

}  // namespace glimt
