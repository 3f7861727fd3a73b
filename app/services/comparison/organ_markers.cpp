// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/comparison/organ_markers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <system_error>

#include <nlohmann/json.hpp>

#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/portable_math.h"
#include "sim/geometry/mesh/nearest_on_triangle.h"
#include "sim/scene/scene_file.h"

namespace torsio {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kMillimetre_m = 1e-3;
constexpr double kFarthestFromSkin_m = 5e-3;
constexpr double kSumTolerance = 1e-6;  ///< for barycentric coordinates, which files contain rounded

/// A field of one marker in a file, for error messages.
struct MarkerField {
  const std::string& file;
  std::size_t marker;  ///< from 1
  const char* field;

  [[noreturn]] void refuseIt(const Text& what, const Text& remedy) const {
    refuse(what, Text::tr("%1, marker %2, field \"%3\"", file, marker, std::string(field)), remedy);
  }
};

/// Reads three finite numbers from a field.
std::array<double, 3> threeNumbers(const Json& entry, const MarkerField& at) {
  const Json& value = entry.at(at.field);
  const auto isNumber = [](const Json& number) {
    return number.is_number() && std::isfinite(number.get<double>());
  };
  if (!value.is_array() || value.size() != 3 || !std::all_of(value.begin(), value.end(), isNumber)) {
    at.refuseIt(Text::tr("Three finite numbers are needed"), Text::tr("Give them as [x, y, z]"));
  }
  return value.get<std::array<double, 3>>();
}

void placeByFace(const Json& entry, const std::string& file, const Scene& scene, OrganMarker& marker) {
  const auto number = static_cast<std::size_t>(marker.number);
  const MarkerField face{file, number, "face"};
  const Json& value = entry.at("face");
  if (!value.is_number_integer() || value.get<std::int64_t>() < 0 ||
      value.get<std::int64_t>() >= static_cast<std::int64_t>(scene.mesh.triangles.size())) {
    face.refuseIt(Text::tr("The organ has %1 faces, numbered from 0", scene.mesh.triangles.size()),
                  Text::tr("Give the number of one of them"));
  }
  const MarkerField weights{file, number, "barycentric"};
  if (!entry.contains("barycentric")) {
    weights.refuseIt(Text::tr("A face alone does not define a point"),
                     Text::tr("Give three numbers that sum to 1"));
  }
  std::array<double, 3> barycentric = threeNumbers(entry, weights);
  const double sum = barycentric[0] + barycentric[1] + barycentric[2];
  if (std::abs(sum - 1.0) > kSumTolerance ||
      *std::min_element(barycentric.begin(), barycentric.end()) < -kSumTolerance) {
    weights.refuseIt(Text::tr("The coordinates are outside the face"),
                     Text::tr("Give three numbers from 0 to 1 that sum to 1"));
  }
  placeMarker(scene, value.get<std::uint32_t>(), barycentric, marker);
}

void placeByPosition(const Json& entry, const std::string& file, const Scene& scene, OrganMarker& marker) {
  const MarkerField field{file, static_cast<std::size_t>(marker.number), "position_mm"};
  if (!entry.contains("position_mm")) {
    field.refuseIt(Text::tr("The marker has no place"),
                   Text::tr("Give face and barycentric, or position_mm"));
  }
  const std::array<double, 3> place_mm = threeNumbers(entry, field);
  const Vec3 wanted_m = kMillimetre_m * Vec3{place_mm[0], place_mm[1], place_mm[2]};
  NearestOnTriangle nearest;
  std::uint32_t face = 0;
  for (std::size_t t = 0; t < scene.mesh.triangles.size(); ++t) {
    const TriangleMesh::Triangle& corners = scene.mesh.triangles[t];
    const NearestOnTriangle found =
        nearestOnTriangle(wanted_m, {scene.mesh.vertices_m[corners[0]], scene.mesh.vertices_m[corners[1]],
                                     scene.mesh.vertices_m[corners[2]]});
    if (found.distance2 < nearest.distance2) {
      nearest = found;
      face = static_cast<std::uint32_t>(t);
    }
  }
  if (!(nearest.distance2 <= kFarthestFromSkin_m * kFarthestFromSkin_m)) {
    field.refuseIt(Text::tr("The place lies more than 5 mm from the organ's surface"),
                   Text::tr("Give a point of the surface, millimetres in the frame of the mesh"));
  }
  placeMarker(scene, face, {nearest.u, nearest.v, nearest.w}, marker);
}

OrganMarker markerOf(const Json& entry, std::size_t number, const std::string& file, const Scene& scene) {
  const MarkerField numbered{file, number, "number"};
  if (!entry.is_object() || !entry.contains("number") || !entry["number"].is_number_integer() ||
      entry["number"].get<std::int64_t>() != static_cast<std::int64_t>(number)) {
    numbered.refuseIt(Text::tr("Markers are numbered 1, 2, 3 and so on"),
                      Text::tr("Number them in their order"));
  }
  const MarkerField named{file, number, "name"};
  if (!entry.contains("name") || !entry["name"].is_string()) {
    named.refuseIt(Text::tr("The marker has no name"), Text::tr("Give a text"));
  }
  OrganMarker marker;
  marker.number = static_cast<int>(number);
  marker.name = entry["name"].get<std::string>();
  entry.contains("face") ? placeByFace(entry, file, scene, marker)
                         : placeByPosition(entry, file, scene, marker);
  return marker;
}

}  // namespace

void placeMarker(const Scene& scene, std::uint32_t face, const std::array<double, 3>& barycentric,
                 OrganMarker& marker) {
  TORSIO_EXPECTS(face < scene.mesh.triangles.size());
  marker.face = face;
  marker.barycentric = barycentric;
  marker.position_m = {};
  for (std::size_t k = 0; k < 3; ++k) {
    marker.position_m += barycentric[k] * scene.mesh.vertices_m[scene.mesh.triangles[face][k]];
  }
}

void checkMarkers(const std::vector<OrganMarker>& markers, const std::string& where) {
  if (markers.empty() || markers.size() > kMaxMarkers) {
    refuse(Text::tr("An organ has 1 to %1 markers, here are %2", kMaxMarkers, markers.size()), where,
           Text::tr("Add or remove some"));
  }
  for (std::size_t i = 0; i < markers.size(); ++i) {
    const auto at = [&] {
      return Text::tr("%1, marker %2, field \"%3\"", where, i + 1, Text::verbatim("name"));
    };
    const std::string& name = markers[i].name;
    if (name.find_first_not_of(" \t\r\n") == std::string::npos) {
      refuse(Text::tr("The marker has no name"), at(), Text::tr("Give a text"));
    }
    for (std::size_t before = 0; before < i; ++before) {
      if (markers[before].name == name) {
        refuse(Text::tr("Markers %1 and %2 have the same name", before + 1, i + 1), at(),
               Text::tr("Give each another name"));
      }
    }
  }
}

std::vector<OrganMarker> readMarkers(const std::filesystem::path& file, const Scene& scene) {
  const std::string name = file.string();
  const Text correct = Text::tr("Give a file as the window saves it (docs/validation.md)");
  Json root;
  try {
    root = Json::parse(readFile(file));
  } catch (const Json::exception& reason) {
    refuse(Text::tr("The markers cannot be read: %1", std::string(reason.what())), name, correct);
  }
  if (!root.is_object() || !root.contains("markers") || !root["markers"].is_array()) {
    refuse(Text::tr("The file has no list \"markers\""), name, correct);
  }
  if (root.contains("organ_hash") && root["organ_hash"] != scene.organHash) {
    refuse(Text::tr("The markers were placed on another organ"), name,
           Text::tr("Choose the organ that they were saved with"));
  }
  std::vector<OrganMarker> markers;
  for (const Json& entry : root["markers"]) {
    markers.push_back(markerOf(entry, markers.size() + 1, name, scene));
  }
  checkMarkers(markers, name);
  return markers;
}

void writeMarkers(const std::filesystem::path& file, const std::vector<OrganMarker>& markers,
                  const Scene& scene) {
  Json root{{"organ", scene.title}, {"organ_hash", scene.organHash}, {"markers", Json::array()}};
  for (const OrganMarker& marker : markers) {
    root["markers"].push_back({{"number", marker.number},
                               {"name", marker.name},
                               {"face", marker.face},
                               {"barycentric", marker.barycentric}});
  }
  writeFileAtomically(file, root.dump(2) + "\n");
}

std::vector<OrganMarker> readOrganMarkers(const std::filesystem::path& assets, const Scene& scene) {
  const std::filesystem::path file = organMarkersFile(assets, scene);
  std::error_code failed;
  return std::filesystem::exists(file, failed) ? readMarkers(file, scene) : std::vector<OrganMarker>{};
}

std::vector<OrganMarker> spreadMarkers(const Scene& scene) {
  constexpr int kAlong = 5;
  std::vector<OrganMarker> markers;
  for (int k = 0; k < kAlong; ++k) {
    for (const double angle_rad : {0.0, kPi}) {
      const double share = (k + 0.5) / kAlong;
      const LatticePoint point =
          scene.lattice().surfacePoint({share * scene.lattice().length_m(), angle_rad});
      OrganMarker marker;
      marker.number = static_cast<int>(markers.size()) + 1;
      marker.name = "section " + std::to_string(std::lround(share * (scene.lattice().sections() - 1)) + 1) +
                    ", ridge " +
                    std::to_string(std::lround(angle_rad / (2.0 * kPi) * scene.lattice().ridges()) + 1);
      placeMarker(scene, point.triangle, point.barycentric, marker);
      markers.push_back(marker);
    }
  }
  return markers;
}

}  // namespace torsio
