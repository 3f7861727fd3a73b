// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/organ_file.h"

#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/geometry/mesh/mesh_file_check.h"
#include "sim/scene/json_fields.h"

namespace torsio {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kMagic = "torsio organ ";
constexpr int kOrganFormat = 1;
constexpr std::size_t kLongestHead = 1'000'000;
constexpr std::size_t kDigestLength = 64;
constexpr double kMicrometres = 1e6;
constexpr long kThickest_um = 50'000;
constexpr std::size_t kVertexBytes = 3 * sizeof(double);
constexpr std::size_t kTriangleBytes = 3 * sizeof(std::uint32_t);
static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

[[noreturn]] void refuseFile(const std::filesystem::path& file, const Text& what) {
  throw Error(ErrorCode::kFileUnreadable, what, file.string(),
              Text::tr("Import the mesh again with torsio organ import"));
}

Json vectorJson(const Vec3& v) {
  return {v.x, v.y, v.z};
}

Vec3 vectorFrom(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

/// Thickness in whole micrometres, below zero where it was filled in.
Json mapJson(const OrganWallMap& map) {
  Json cells = Json::array();
  for (std::size_t n = 0; n < map.thickness_m.size(); ++n) {
    const auto thickness_um = std::lround(kMicrometres * map.thickness_m[n]);
    cells.push_back(map.seen[n] != 0 ? thickness_um : -thickness_um);
  }
  return {{"bands", map.bands}, {"ridges", map.ridges}, {"thickness_um", cells}};
}

std::optional<OrganWallMap> mapFrom(const Json& json) {
  OrganWallMap map;
  map.bands = json.at("bands").get<int>();
  map.ridges = json.at("ridges").get<int>();
  for (const auto& cell : json.at("thickness_um")) {
    const long thickness_um = cell.get<long>();
    if (thickness_um == 0 || std::abs(thickness_um) > kThickest_um) {
      return std::nullopt;
    }
    map.thickness_m.push_back(static_cast<double>(std::abs(thickness_um)) / kMicrometres);
    map.seen.push_back(thickness_um > 0 ? 1 : 0);
  }
  const bool whole =
      map.bands > 0 && map.ridges > 0 && map.bands < kMaxSections && map.ridges <= kMaxRidges &&
      map.thickness_m.size() == static_cast<std::size_t>(map.bands) * static_cast<std::size_t>(map.ridges);
  return whole ? std::optional(std::move(map)) : std::nullopt;
}

std::string digestOf(std::string_view bytes) {
  Digest digest;
  digest.update(bytes);
  return digest.hex();
}

Json headOf(const OrganFile& organ) {
  Json head;
  head["source"] = organ.source;
  head["frame"] = "LPS, metres";
  head["vertices"] = organ.mesh.vertices_m.size();
  head["triangles"] = organ.mesh.triangles.size();
  if (organ.ends.fixedEnd_m && organ.ends.freeEnd_m) {
    head["fixed_end_m"] = vectorJson(*organ.ends.fixedEnd_m);
    head["free_end_m"] = vectorJson(*organ.ends.freeEnd_m);
  }
  head["fixed_cut"] = vectorJson(organ.ends.fixedCut);
  head["free_cut"] = vectorJson(organ.ends.freeCut);
  if (organ.ends.capRadius_m > 0.0) {
    head["cap_radius_m"] = organ.ends.capRadius_m;
  }
  if (organ.ends.straight) {
    head["straight"] = true;
  }
  if (organ.ends.branchCut != Vec3{}) {
    head["branch_root_m"] = vectorJson(organ.ends.branchRoot_m);
    head["branch_cut"] = vectorJson(organ.ends.branchCut);
  }
  head["anatomy"] = organ.anatomy;
  if (organ.wall_m) {
    head["wall_m"] = *organ.wall_m;
  }
  if (organ.wallMap) {
    head["wall_map"] = mapJson(*organ.wallMap);
  }
  if (!organ.patterns.empty()) {
    head["patterns"] = organ.patterns;
  }
  head["warnings"] = warningsJson(organ.warnings);
  return head;
}

OrganFile organOfHead(const Json& head) {
  OrganFile organ;
  organ.source = head.at("source").get<std::string>();
  if (head.contains("fixed_end_m")) {
    organ.ends.fixedEnd_m = vectorFrom(head.at("fixed_end_m"));
    organ.ends.freeEnd_m = vectorFrom(head.at("free_end_m"));
  }
  organ.ends.fixedCut = vectorFrom(head.at("fixed_cut"));
  organ.ends.freeCut = vectorFrom(head.at("free_cut"));
  organ.ends.capRadius_m = head.value("cap_radius_m", 0.0);
  organ.ends.straight = head.value("straight", false);
  if (head.contains("branch_cut")) {
    organ.ends.branchRoot_m = vectorFrom(head.at("branch_root_m"));
    organ.ends.branchCut = vectorFrom(head.at("branch_cut"));
  }
  organ.anatomy = head.at("anatomy").get<std::string>();
  if (head.contains("wall_m")) {
    organ.wall_m = head.at("wall_m").get<double>();
  }
  if (head.contains("wall_map")) {
    organ.wallMap = mapFrom(head.at("wall_map"));
  }
  organ.patterns = head.value("patterns", std::vector<std::string>{});
  organ.warnings = warningsOf(head.at("warnings"));
  return organ;
}

/// Takes the surface out of the bytes behind the head; false when there are more or less of them.
bool takeSurface(std::string_view bytes, std::uint64_t vertices, std::uint64_t triangles,
                 TriangleMesh& mesh) {
  constexpr std::uint64_t kMost = 2 * std::uint64_t{kMaxTriangles};
  if (vertices > kMost || triangles > kMost ||
      bytes.size() != vertices * kVertexBytes + triangles * kTriangleBytes) {
    return false;
  }
  mesh.vertices_m.resize(vertices);
  mesh.triangles.resize(triangles);
  for (std::uint64_t i = 0; i < vertices; ++i) {
    double xyz[3];
    std::memcpy(xyz, bytes.data() + i * kVertexBytes, kVertexBytes);
    mesh.vertices_m[i] = {xyz[0], xyz[1], xyz[2]};
  }
  const char* const corners = bytes.data() + vertices * kVertexBytes;
  for (std::uint64_t i = 0; i < triangles; ++i) {
    std::memcpy(mesh.triangles[i].data(), corners + i * kTriangleBytes, kTriangleBytes);
  }
  return true;
}

}  // namespace

bool isOrganFile(const std::filesystem::path& file) {
  return lowerExtension(file) == "organ";
}

void writeOrganFile(const std::filesystem::path& file, const OrganFile& organ) {
  std::string bytes = std::string(kMagic) + std::to_string(kOrganFormat) + "\n" + headOf(organ).dump() + "\n";
  for (const Vec3& v : organ.mesh.vertices_m) {
    const double xyz[3] = {v.x, v.y, v.z};
    bytes.append(reinterpret_cast<const char*>(xyz), sizeof(xyz));
  }
  for (const TriangleMesh::Triangle& t : organ.mesh.triangles) {
    bytes.append(reinterpret_cast<const char*>(t.data()), kTriangleBytes);
  }
  bytes += digestOf(bytes);
  writeFileAtomically(file, bytes);
}

OrganFile readOrganFile(const std::filesystem::path& file) {
  const std::string all = readFile(file);
  const std::size_t line = all.find('\n');
  if (!all.starts_with(kMagic) || line == std::string::npos || line > kMagic.size() + 4) {
    refuseFile(file, Text::tr("not an organ file of Torsio"));
  }
  if (all.substr(kMagic.size(), line - kMagic.size()) != std::to_string(kOrganFormat)) {
    refuseFile(file, Text::tr("the organ file was written by a later version"));
  }
  const std::size_t head = all.find('\n', line + 1);
  if (head == std::string::npos || head - line > kLongestHead || all.size() < head + 1 + kDigestLength) {
    refuseFile(file, Text::tr("the organ file is cut short"));
  }
  const std::string_view bytes(all);
  const std::string_view sealed = bytes.substr(0, bytes.size() - kDigestLength);
  if (digestOf(sealed) != bytes.substr(sealed.size())) {
    refuseFile(file, Text::tr("the organ file was damaged or changed"));
  }
  OrganFile organ;
  try {
    const Json json = Json::parse(sealed.substr(line + 1, head - line - 1));
    organ = organOfHead(json);
    if (!takeSurface(sealed.substr(head + 1), json.at("vertices").get<std::uint64_t>(),
                     json.at("triangles").get<std::uint64_t>(), organ.mesh)) {
      refuseFile(file, Text::tr("the organ file is cut short"));
    }
  } catch (const nlohmann::json::exception&) {
    refuseFile(file, Text::tr("the organ file has no head that can be read"));
  }
  organ.mesh = requireOrgan(std::move(organ.mesh), file.string());
  return organ;
}

}  // namespace torsio
