// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/core/byte_order_mark.h"
#include "sim/core/error.h"
#include "sim/geometry/mesh/mesh_file_check.h"

namespace torsio {

namespace {

using Json = nlohmann::json;

constexpr std::uint64_t kMaxNumber = 1'000'000'000'000ULL;  // products of two cannot overflow
constexpr std::uint64_t kLeastRoom_bytes = 64'000'000;
constexpr std::uint64_t kLargestBeside_bytes = 500'000'000;  // of a buffer in a file of its own
constexpr std::uint64_t kCopies = 16;  // of a file's bytes: parts of a mesh may share their vertices

[[noreturn]] void refuseGltf(const std::string& where, const std::string& what) {
  refuseRow(where, what, Text::tr("it promises more than the file holds"));
}

/// A non-negative whole number of an object; `otherwise` if it is absent.
std::uint64_t numberAt(const Json& object, const char* name, std::uint64_t otherwise,
                       const std::string& where) {
  const auto found = object.find(name);
  if (found == object.end()) {
    return otherwise;
  }
  if (!found->is_number_unsigned() || found->get<std::uint64_t>() > kMaxNumber) {
    refuseGltf(where, std::string("the number \"").append(name).append("\""));
  }
  return found->get<std::uint64_t>();
}

const Json& listAt(const Json& object, const char* name) {
  static const Json kNone = Json::array();
  const auto found = object.is_object() ? object.find(name) : object.end();
  return found == object.end() || !found->is_array() ? kNone : *found;
}

std::uint64_t componentBytes(std::uint64_t type) {
  constexpr std::array<std::pair<std::uint64_t, std::uint64_t>, 6> kBytes{
      {{5120, 1}, {5121, 1}, {5122, 2}, {5123, 2}, {5125, 4}, {5126, 4}}};
  for (const auto& [known, bytes] : kBytes) {
    if (known == type) {
      return bytes;
    }
  }
  return 4;
}

std::uint64_t componentsOf(const std::string& type) {
  constexpr std::array<std::pair<std::string_view, std::uint64_t>, 6> kCounts{
      {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}}};
  for (const auto& [known, count] : kCounts) {
    if (known == type) {
      return count;
    }
  }
  return 16;
}

/// Compares what the lists of a glTF file promise with what its buffers hold.
class GltfPromises {
 public:
  GltfPromises(const Json& json, std::uint64_t binary, std::uint64_t file, const std::string& where)
      : json_(json), file_(file), where_(where) {
    for (const Json& buffer : listAt(json, "buffers")) {
      const std::uint64_t length =
          object(buffer, "a buffer").contains("byteLength") ? numberAt(buffer, "byteLength", 0, where_) : 0;
      const auto uri = buffer.find("uri");
      const bool embedded =
          uri != buffer.end() && uri->is_string() && uri->get_ref<const std::string&>().starts_with("data:");
      const std::uint64_t held = uri == buffer.end() ? binary : embedded ? file : kLargestBeside_bytes;
      if (length > held) {
        refuseGltf(where_, name("buffer", buffers_.size()));
      }
      buffers_.push_back(length);
    }
  }

  void check() {
    for (const Json& view : listAt(json_, "bufferViews")) {
      const std::uint64_t buffer = numberAt(object(view, "a buffer view"), "buffer", 0, where_);
      const std::uint64_t length = numberAt(view, "byteLength", 0, where_);
      if (buffer >= buffers_.size() || numberAt(view, "byteOffset", 0, where_) + length > buffers_[buffer]) {
        refuseGltf(where_, name("buffer view", views_.size()));
      }
      views_.push_back({length, numberAt(view, "byteStride", 0, where_)});
    }
    for (const Json& accessor : listAt(json_, "accessors")) {
      accessors_.push_back(accessorBytes(object(accessor, "an accessor")));
    }
    for (const Json& mesh : listAt(json_, "meshes")) {
      for (const Json& part : listAt(mesh, "primitives")) {
        takePart(object(part, "a part of a mesh"));
      }
    }
    for (const Json& animation : listAt(json_, "animations")) {
      for (const Json& sampler : listAt(animation, "samplers")) {
        take(object(sampler, "a sampler"), "input");
        take(sampler, "output");
      }
    }
    for (const Json& skin : listAt(json_, "skins")) {
      take(object(skin, "a skin"), "inverseBindMatrices");
    }
    for (const Json& image : listAt(json_, "images")) {
      if (object(image, "an image").contains("bufferView")) {
        const std::uint64_t view = numberAt(image, "bufferView", 0, where_);
        add(view < views_.size() ? views_[view].length : kMaxNumber, "images");
      }
    }
  }

 private:
  struct View {
    std::uint64_t length = 0;
    std::uint64_t stride = 0;
  };

  static std::string name(const char* kind, std::size_t at) {
    return std::string(kind).append(" ").append(std::to_string(at));
  }

  const Json& object(const Json& json, const char* what) const {
    if (!json.is_object()) {
      refuseGltf(where_, what);
    }
    return json;
  }

  std::uint64_t accessorBytes(const Json& accessor) const {
    const std::uint64_t count = numberAt(accessor, "count", 0, where_);
    const auto type = accessor.find("type");
    const std::uint64_t size =
        componentBytes(numberAt(accessor, "componentType", 0, where_)) *
        componentsOf(type != accessor.end() && type->is_string() ? type->get<std::string>() : std::string());
    if (accessor.contains("bufferView")) {
      const std::uint64_t view = numberAt(accessor, "bufferView", 0, where_);
      const std::uint64_t offset = numberAt(accessor, "byteOffset", 0, where_);
      const std::uint64_t step = view < views_.size() ? std::max(size, views_[view].stride) : kMaxNumber;
      const bool held = view < views_.size() && step <= file_ &&
                        (count == 0 || offset + (count - 1) * step + size <= views_[view].length);
      if (!held) {
        refuseGltf(where_, name("accessor", accessors_.size()));
      }
    }
    return count * size;
  }

  void takePart(const Json& part) {
    take(part, "indices");
    takeAll(part.value("attributes", Json::object()));
    for (const Json& target : listAt(part, "targets")) {
      takeAll(target);
    }
  }
  void takeAll(const Json& attributes) {
    if (attributes.is_object()) {
      for (const auto& [key, accessor] : attributes.items()) {
        take(attributes, key.c_str());
      }
    }
  }
  /// Adds the bytes of the accessor that a field names.
  void take(const Json& owner, const char* field) {
    if (owner.contains(field)) {
      const std::uint64_t at = numberAt(owner, field, 0, where_);
      add(at < accessors_.size() ? accessors_[at] : kMaxNumber, field);
    }
  }
  void add(std::uint64_t bytes, const char* what) {
    taken_ += bytes;
    if (taken_ > kLeastRoom_bytes + kCopies * file_) {
      refuseGltf(where_, what);
    }
  }

  const Json& json_;
  std::uint64_t file_;
  const std::string& where_;
  std::vector<std::uint64_t> buffers_;
  std::vector<View> views_;
  std::vector<std::uint64_t> accessors_;  // bytes that the importer needs for each
  std::uint64_t taken_ = 0;
};

std::uint32_t wordAt(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  }
  return value;
}

}  // namespace

void requirePlausibleGltf(std::string_view bytes, std::string_view extension, const std::string& where) {
  std::string_view text = withoutByteOrderMark(bytes);
  std::uint64_t binary = 0;
  if (extension == "glb") {
    constexpr std::size_t kHeader = 20;  // of the file and of its first chunk
    constexpr std::uint32_t kVersion = 2;
    if (bytes.size() < kHeader || wordAt(bytes, 4) != kVersion) {
      refuseFormat(where, "GLB", Text::tr("it is not of version 2"));
    }
    const std::uint64_t length = wordAt(bytes, 12);
    if (kHeader + length > bytes.size()) {
      refuseShort(where, std::to_string(length) + " bytes of JSON", bytes.size());
    }
    text = bytes.substr(kHeader, length);
    binary = bytes.size() - kHeader - length;
  }
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) {
    refuseFormat(where, extension == "glb" ? "GLB" : "glTF", Text::tr("its JSON is damaged"));
  }
  const Json version = json.value("asset", Json::object()).is_object()
                           ? json.value("asset", Json::object()).value("version", Json())
                           : Json();
  if (!version.is_string() || !version.get_ref<const std::string&>().starts_with("2")) {
    refuseFormat(where, extension == "glb" ? "GLB" : "glTF", Text::tr("it is not of version 2"));
  }
  GltfPromises promises(json, binary, bytes.size(), where);
  promises.check();
}

}  // namespace torsio
