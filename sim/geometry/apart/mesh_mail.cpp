// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/apart/mesh_mail.h"

#include <cstdint>
#include <cstring>
#include <type_traits>

#include "sim/core/text_packing.h"
#include "sim/geometry/apart/helper_process.h"

namespace torsio {

namespace {

constexpr std::uint32_t kMeshMail = 0x4d455348;     // "MESH"
constexpr std::uint32_t kRefusalMail = 0x4e4f2121;  // "NO!!"

struct MailHead {
  std::uint32_t kind = 0;
  std::int32_t code = 0;  ///< of a refusal
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  std::uint64_t textures = 0;
  std::uint64_t bones = 0;
  std::uint64_t animations = 0;
};
static_assert(std::is_trivially_copyable_v<MailHead>);
static_assert(sizeof(Vec3) == 3 * sizeof(double) && std::is_trivially_copyable_v<Vec3>);

void append(std::string& bytes, const void* data, std::size_t size) {
  bytes.append(static_cast<const char*>(data), size);
}

[[noreturn]] void refuseMail(const std::string& where) {
  throw Error(ErrorCode::kFileUnreadable, Text::tr("M05 the importer gave no answer to this file"), where,
              Text::tr("Export the mesh again, or in another format"));
}

}  // namespace

std::string mailOf(const RawMesh& mesh) {
  MailHead head;
  head.kind = kMeshMail;
  head.vertices = mesh.mesh.vertices_m.size();
  head.triangles = mesh.mesh.triangles.size();
  head.textures = mesh.ignored.textures;
  head.bones = mesh.ignored.bones;
  head.animations = mesh.ignored.animations;
  std::string bytes;
  bytes.reserve(sizeof(head) + head.vertices * sizeof(Vec3) +
                head.triangles * sizeof(TriangleMesh::Triangle));
  append(bytes, &head, sizeof(head));
  append(bytes, mesh.mesh.vertices_m.data(), head.vertices * sizeof(Vec3));
  append(bytes, mesh.mesh.triangles.data(), head.triangles * sizeof(TriangleMesh::Triangle));
  return bytes;
}

std::string mailOf(const Error& refusal) {
  MailHead head;
  head.kind = kRefusalMail;
  head.code = static_cast<std::int32_t>(refusal.code());
  std::string bytes;
  append(bytes, &head, sizeof(head));
  TextPacker texts;
  texts.text(refusal.happenedText());
  texts.text(refusal.whereText());
  texts.text(refusal.remedyText());
  return bytes + texts.bytes();
}

RawMesh meshOfMail(std::span<const char> bytes, const std::string& where) {
  MailHead head;
  if (bytes.size() < sizeof(head)) {
    refuseMail(where);
  }
  std::memcpy(&head, bytes.data(), sizeof(head));
  const std::span<const char> rest = bytes.subspan(sizeof(head));
  const bool known = head.code == static_cast<int>(ErrorCode::kFileMissing) ||
                     head.code == static_cast<int>(ErrorCode::kFileUnreadable) ||
                     head.code == static_cast<int>(ErrorCode::kBadMesh);
  if (head.kind == kRefusalMail && known) {
    const std::string packed(rest.begin(), rest.end());
    TextUnpacker texts(packed);
    Text what;
    Text place;
    Text remedy;
    texts.text(what);
    texts.text(place);
    texts.text(remedy);
    throw Error(static_cast<ErrorCode>(head.code), what, place, remedy);
  }
  constexpr std::uint64_t kMost = kMaxAnswerBytes;
  if (head.kind != kMeshMail || head.vertices > kMost || head.triangles > kMost ||
      rest.size() != head.vertices * sizeof(Vec3) + head.triangles * sizeof(TriangleMesh::Triangle)) {
    refuseMail(where);
  }
  RawMesh mesh;
  mesh.mesh.vertices_m.resize(head.vertices);
  mesh.mesh.triangles.resize(head.triangles);
  const std::size_t split = head.vertices * sizeof(Vec3);
  if (head.vertices > 0) {
    std::memcpy(static_cast<void*>(mesh.mesh.vertices_m.data()), rest.data(), split);
  }
  if (head.triangles > 0) {
    std::memcpy(mesh.mesh.triangles.data(), rest.data() + split, rest.size() - split);
  }
  mesh.ignored = {head.textures, head.bones, head.animations};
  return mesh;
}

}  // namespace torsio
