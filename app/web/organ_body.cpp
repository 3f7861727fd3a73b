// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/organ_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/web/binary_container.h"
#include "sim/core/file_io.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "sim/scene/tissue_look.h"

namespace torsio::web {

namespace {

constexpr float kMillimetresAMetre = 1000.0F;

void addMesh(BinaryContainer& container, const std::string& name, const TriangleMesh& mesh) {
  std::vector<std::uint32_t> index;
  for (const TriangleMesh::Triangle& triangle : mesh.triangles) {
    index.insert(index.end(), triangle.begin(), triangle.end());
  }
  container.addDifferences(name, std::span<const std::uint32_t>(index), 3);
}

/// Adds shaft and jaws in the instrument's frame, in this order.
void addInstrument(BinaryContainer& container, const std::filesystem::path& assets, const std::string& id) {
  const std::filesystem::path folder = assets / "instruments";
  const nlohmann::json file = nlohmann::json::parse(readFile(folder / (id + ".json")));
  TriangleMesh whole;
  nlohmann::json parts = nlohmann::json::array();
  for (const char* part : {"shaft", "upper_jaw", "lower_jaw"}) {
    const TriangleMesh mesh = importMesh(folder / file.at("meshes").at(part).get<std::string>(),
                                         {.scale_m = 0.001, .organ = false});
    const auto first = static_cast<std::uint32_t>(whole.vertices_m.size());
    parts.push_back({{"name", part}, {"first", first}, {"count", mesh.vertices_m.size()}});
    whole.vertices_m.insert(whole.vertices_m.end(), mesh.vertices_m.begin(), mesh.vertices_m.end());
    for (const TriangleMesh::Triangle& t : mesh.triangles) {
      whole.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
  }
  std::vector<float> places;
  for (const Vec3& p : whole.vertices_m) {
    for (const double part : {p.x, p.y, p.z}) {
      places.push_back(kMillimetresAMetre * static_cast<float>(part));
    }
  }
  addMesh(container, "tool_index", whole);
  container.add("tool_mean", std::span<const float>(places));
  container.meta()["tool"] = {{"parts", parts},
                              {"pivot_mm", file.at("jaws").at("pivot_mm")},
                              {"opening_deg", file.at("jaws").at("opening_deg")}};
}

/// Returns the unlit colour of each vertex as in the window: tissue colour and patches.
std::vector<std::uint8_t> tissueColours(const Scene& scene) {
  const TissueLook look = tissueLook(scene.id);
  std::vector<std::uint8_t> colours;
  colours.reserve(3 * scene.mesh.vertices_m.size());
  for (const Vec3& place_m : scene.mesh.vertices_m) {
    const std::array<float, 3> factor = mottle(look, place_m);
    for (std::size_t k = 0; k < factor.size(); ++k) {
      // The factor applies to linear light; the page's shader squares its input.
      constexpr float kWhite = 255.0F;
      const float byte = static_cast<float>(look.colour[k]) * std::sqrt(std::max(factor[k], 0.0F));
      colours.push_back(static_cast<std::uint8_t>(std::lround(std::min(byte, kWhite))));
    }
  }
  return colours;
}

}  // namespace

std::string organBody(const Scene& scene, const ShapeBasis& basis, const std::filesystem::path& assets) {
  BinaryContainer container;
  container.meta() = {
      {"vertices", scene.mesh.vertices_m.size()}, {"components", basis.components()}, {"scale", basis.scale}};
  addMesh(container, "index", scene.mesh);
  container.addMultiples("mean", basis.mean, basis.meanStep, 3);
  container.addDifferences("basis", std::span<const std::int16_t>(basis.steps), 3);
  container.add("colour", std::span<const std::uint8_t>(tissueColours(scene)));
  addInstrument(container, assets, "grasper");
  return gzipped(container.bytes());
}

}  // namespace torsio::web
