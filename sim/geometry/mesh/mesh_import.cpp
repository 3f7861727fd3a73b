// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/mesh_import.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <iterator>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <assimp/BaseImporter.h>
#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include "sim/core/byte_order_mark.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/plain_text.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/geometry/mesh/mesh_file_check.h"
#include "sim/geometry/mesh/mesh_space.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::string_view, 7> kFormats{"obj", "stl", "ply", "off", "glb", "gltf", "dae"};
constexpr std::uintmax_t kMaxBytes = 500'000'000;

// Opens nothing outside the folder of the mesh: a file must not name "../../etc/passwd" as its material.
class FolderOnly final : public Assimp::DefaultIOSystem {
 public:
  explicit FolderOnly(const fs::path& file) {
    std::error_code ignored;
    folder_ = fs::weakly_canonical(fs::absolute(file).parent_path(), ignored);
  }
  bool Exists(const char* file) const override { return inside(file) && DefaultIOSystem::Exists(file); }
  Assimp::IOStream* Open(const char* file, const char* mode) override {
    return inside(file) && std::strchr(mode, 'w') == nullptr ? DefaultIOSystem::Open(file, mode) : nullptr;
  }

 private:
  bool inside(const char* file) const {
    std::error_code failed;
    const fs::path wanted = fs::weakly_canonical(fs::absolute(file, failed), failed);
    const auto split = std::mismatch(folder_.begin(), folder_.end(), wanted.begin(), wanted.end());
    return !failed && split.first == folder_.end();
  }
  fs::path folder_;
};

// Leaves only the readers of `extension`, so that no other parser ever sees the file.
void keepLoaders(Assimp::Importer& importer, const std::string& extension) {
  for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
    const aiImporterDesc* const info = importer.GetImporterInfo(i);
    std::istringstream known(info != nullptr ? info->mFileExtensions : "");
    if (std::find(std::istream_iterator<std::string>(known), {}, extension) !=
        std::istream_iterator<std::string>{}) {
      continue;
    }
    const std::unique_ptr<Assimp::BaseImporter> owned(importer.GetImporter(i));
    importer.UnregisterLoader(owned.get());
  }
}

Vec3 transformed(const aiMatrix4x4& m, const aiVector3D& v) {
  return {
      double{m.a1} * double{v.x} + double{m.a2} * double{v.y} + double{m.a3} * double{v.z} + double{m.a4},
      double{m.b1} * double{v.x} + double{m.b2} * double{v.y} + double{m.b3} * double{v.z} + double{m.b4},
      double{m.c1} * double{v.x} + double{m.c2} * double{v.y} + double{m.c3} * double{v.z} + double{m.c4}};
}

void append(TriangleMesh& mesh, const aiMesh& part, const aiMatrix4x4& toWorld, double scale_m,
            const std::string& where) {
  if (!part.HasPositions() || mesh.triangles.size() + part.mNumFaces > 2 * kMaxTriangles) {
    if (part.HasPositions()) {
      throw Error(ErrorCode::kBadMesh, Text::tr("M03 more than %1 triangles", std::to_string(kMaxTriangles)),
                  where, Text::tr("Decimate the surface"));
    }
    return;
  }
  const auto first = static_cast<std::uint32_t>(mesh.vertices_m.size());
  for (unsigned i = 0; i < part.mNumVertices; ++i) {
    mesh.vertices_m.push_back(scale_m * transformed(toWorld, part.mVertices[i]));
  }
  const bool mirrored = toWorld.Determinant() < 0;
  for (unsigned f = 0; f < part.mNumFaces; ++f) {
    const aiFace& face = part.mFaces[f];
    if (face.mNumIndices != 3) {
      continue;
    }
    TriangleMesh::Triangle t{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (face.mIndices[k] >= part.mNumVertices) {
        throw Error(ErrorCode::kBadMesh,
                    Text::tr("M08 face %1 uses vertex %2 of %3", std::to_string(f),
                             std::to_string(face.mIndices[k]), std::to_string(part.mNumVertices)),
                    where, Text::tr("Export the mesh again"));
      }
      t[k] = first + face.mIndices[k];
    }
    if (mirrored) {
      std::swap(t[1], t[2]);
    }
    mesh.triangles.push_back(t);
  }
}

TriangleMesh flatten(const aiScene& scene, double scale_m, const std::string& where) {
  TriangleMesh mesh;
  if (scene.mRootNode == nullptr) {
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
      append(mesh, *scene.mMeshes[i], {}, scale_m, where);
    }
    return mesh;
  }
  std::vector<std::pair<const aiNode*, aiMatrix4x4>> open{
      {scene.mRootNode, scene.mRootNode->mTransformation}};
  while (!open.empty()) {
    const auto [node, toWorld] = open.back();
    open.pop_back();
    for (unsigned i = 0; i < node->mNumMeshes; ++i) {
      if (node->mMeshes[i] < scene.mNumMeshes) {
        append(mesh, *scene.mMeshes[node->mMeshes[i]], toWorld, scale_m, where);
      }
    }
    for (unsigned i = node->mNumChildren; i-- > 0;) {
      open.emplace_back(node->mChildren[i], toWorld * node->mChildren[i]->mTransformation);
    }
  }
  return mesh;
}

MeshExtras extrasOf(const aiScene& scene) {
  MeshExtras extras;
  extras.textures = scene.mNumTextures;
  extras.animations = scene.mNumAnimations;
  for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
    extras.bones += scene.mMeshes[i]->mNumBones;
  }
  for (unsigned i = 0; i < scene.mNumMaterials; ++i) {
    extras.textures += scene.mMaterials[i]->GetTextureCount(aiTextureType_DIFFUSE);
  }
  return extras;
}

/// A text STL file as one solid in small letters: assimp 5.2 ends at a solid without facets, and does not
/// read a file that begins with a blank, a byte order mark or a capital.
std::string plainStl(const fs::path& file) {
  const std::string bytes = readFile(file);
  std::string plain = "solid\n";
  TextLines lines(withoutByteOrderMark(bytes));
  while (const auto line = lines.next()) {
    std::string small = smallLetters(*line);
    const std::size_t start = std::min(small.find_first_not_of(" \t\r"), small.size());
    if (small.compare(start, 5, "solid") == 0 || small.compare(start, 8, "endsolid") == 0) {
      small.erase(0, small.find("facet normal"));  // a name may be followed by facets on its line
    }
    plain += small + '\n';
  }
  if (plain.find("facet") == std::string::npos) {
    requireSound({}, file.string());
  }
  return plain + "endsolid\n";
}

/// The bytes of a binary PLY file that assimp 5.2 would misread: where they begin with 0x0A it takes that for
/// the second half of a line end and shifts all that follows. One more is put before it. Else empty.
std::string mendedPly(const fs::path& file) {
  constexpr std::string_view kEnd = "\nend_header\n";
  constexpr std::size_t kHead = 65'536;
  std::string bytes = readFile(file);
  const std::size_t end = std::string_view(bytes).substr(0, kHead).find(kEnd);
  const std::size_t body = end + kEnd.size();
  if (end == std::string::npos || body >= bytes.size() || bytes[body] != '\n') {
    return {};
  }
  bytes.insert(body, 1, '\n');
  return bytes;
}

/// The bytes to read in place of a file; empty: the file itself.
std::string mendedBytes(const fs::path& file, const std::string& extension) {
  if (extension == "ply") {
    return mendedPly(file);
  }
  return extension == "stl" && isTextStl(headOf(file), fs::file_size(file)) ? plainStl(file) : std::string();
}

/// Turns a surface as a file has it to LPS.
void turnToLps(const MeshSpace& space, TriangleMesh& mesh) {
  for (Vec3& v : mesh.vertices_m) {
    v = space.toLps(v);
  }
}

RawMesh readWithAssimp(const fs::path& file, const std::string& extension, double scale_m) {
  Assimp::Importer importer;
  keepLoaders(importer, extension);
  importer.SetIOHandler(new FolderOnly(file));  // owned by the importer
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  constexpr unsigned kSteps = aiProcess_Triangulate | aiProcess_SortByPType;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const std::string mended = mendedBytes(file, extension);
  const aiScene* const scene =
      mended.empty() ? importer.ReadFile(file.string(), kSteps)
                     : importer.ReadFileFromMemory(mended.data(), mended.size(), kSteps, extension.c_str());
  if (scene == nullptr) {
    const std::string reason = plainLine(importer.GetErrorString());
    // assimp's words after points and lines were dropped
    if (reason == "No meshes remaining") {
      requireSound({}, file.string());
    }
    throw Error(ErrorCode::kFileUnreadable, Text::tr("M05 the importer failed on this file: %1", reason),
                file.string(), Text::tr("Export the mesh again"));
  }
  const MeshSpace space = meshSpaceOf(file);
  // assimp has brought COLLADA to metres already
  const double perNumber_m = extension == "dae" ? scale_m / space.unit_m.value_or(1.0) : scale_m;
  RawMesh read{flatten(*scene, perNumber_m, file.string()), extrasOf(*scene)};
  turnToLps(space, read.mesh);
  return read;
}

void requireThere(const fs::path& file) {
  std::error_code failed;
  const fs::file_status status = fs::status(file, failed);
  if (!fs::exists(status)) {
    throw Error(ErrorCode::kFileMissing, Text::tr("M01 no such file"), file.string(),
                Text::tr("Check the path"));
  }
  if (!fs::is_regular_file(status)) {
    throw Error(ErrorCode::kFileUnreadable, Text::tr("M01 not a file"), file.string(),
                Text::tr("Name a mesh file, not a folder"));
  }
  const std::uintmax_t size = fs::file_size(file, failed);
  if (!failed && size == 0) {
    throw Error(ErrorCode::kFileUnreadable, Text::tr("M01 the file is empty"), file.string(),
                Text::tr("Export the mesh again"));
  }
  if (failed || size > kMaxBytes) {
    throw Error(ErrorCode::kFileUnreadable,
                Text::tr("M03 the file has more than %1 MB", std::to_string(kMaxBytes / 1'000'000)),
                file.string(), Text::tr("Decimate the surface"));
  }
}

constexpr double kWeldShare = 1e-6;  // of the largest side

}  // namespace

void requireMeshFile(const fs::path& file) {
  requireThere(file);
  const std::string extension = lowerExtension(file);
  if (std::find(kFormats.begin(), kFormats.end(), extension) == kFormats.end()) {
    throw Error(ErrorCode::kFileUnreadable,
                Text::tr("M02 files with the extension \"%1\" are not read", plainLine(extension)),
                file.string(), Text::tr("Use obj, stl, ply, off, glb, gltf or dae"));
  }
}

RawMesh readMesh(const fs::path& file, double scale_m) {
  requireMeshFile(file);
  const std::string extension = lowerExtension(file);
  requirePlausibleFile(file, extension);
  return readWithAssimp(file, extension, scale_m);
}

namespace fs = std::filesystem;

double lengthUnit_m(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, double>, 4> kUnits{
      {{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"um", 1e-6}}};
  for (const auto& [known, metres] : kUnits) {
    if (name == known) {
      return metres;
    }
  }
  throw Error(ErrorCode::kBadParameter, Text::tr("unknown unit \"%1\"", plainLine(std::string(name))), "",
              Text::tr("Use m, cm, mm or um"));
}

void requireUnit(double scale_m, const std::string& where) {
  if (!(scale_m >= 1e-9 && scale_m <= 1e3)) {
    throw Error(ErrorCode::kBadParameter, Text::tr("the file unit must lie between 1e-9 and 1000 m"), where,
                Text::tr("Use m, cm, mm or um"));
  }
}

TriangleMesh checkedMesh(TriangleMesh mesh, const std::string& where, const MeshImportOptions& options,
                         MeshRepairs* repairs) {
  requireSound(mesh, where);
  MeshRepairs done;
  weldVertices(mesh, kWeldShare * boxOf(mesh.vertices_m).largestSide(), done);
  done = {};  // the importer gives every face its own corners: the file is not to blame
  if (options.organ) {
    mesh = requireOrgan(std::move(mesh), where,
                        options.unitStated ? std::nullopt : std::optional(options.scale_m), &done);
  } else {
    requireNearOrigin(mesh, where);
    removeDegenerateFaces(mesh, done);
    requireSound(mesh, where);
  }
  if (repairs != nullptr) {
    *repairs = done;
  }
  return mesh;
}

TriangleMesh importMesh(const fs::path& file, const MeshImportOptions& options, MeshRepairs* repairs) {
  requireUnit(options.scale_m, file.string());
  return checkedMesh(readMesh(file, options.scale_m).mesh, file.string(), options, repairs);
}

}  // namespace torsio
