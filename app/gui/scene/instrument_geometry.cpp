// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/instrument_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include <QByteArray>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/geometry/apart/mesh_process.h"
#include "sim/geometry/mesh/mesh_import.h"

namespace torsio::gui {

namespace {

using Attribute = QQuick3DGeometry::Attribute;

constexpr double kSharpEdgeCosine = 0.819;  // 35 degrees
constexpr float kMillimetres = 1000.0F;
constexpr double kInstrumentUnit_m = 1e-3;

QVector3D millimetres(const Vec3& p) {
  return QVector3D(static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)) * kMillimetres;
}

/// Returns three corners per triangle, with normals averaged over the adjacent faces on the same side of
/// sharp edges.
std::vector<EdgeVertex> cornersOf(const TriangleMesh& mesh) {
  std::vector<Vec3> faces;
  std::vector<std::vector<std::uint32_t>> around(mesh.vertices_m.size());
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.vertices_m[t[0]];
    for (const std::uint32_t corner : t) {
      around[corner].push_back(static_cast<std::uint32_t>(faces.size()));
    }
    faces.push_back(cross(mesh.vertices_m[t[1]] - a, mesh.vertices_m[t[2]] - a));  // weighted by area
  }
  std::vector<EdgeVertex> corners;
  corners.reserve(3 * faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Vec3 own = normalized(faces[f]);
    for (const std::uint32_t corner : mesh.triangles[f]) {
      Vec3 sum;
      for (const std::uint32_t other : around[corner]) {
        if (dot(own, normalized(faces[other])) >= kSharpEdgeCosine) {
          sum += faces[other];
        }
      }
      const Vec3 n = normalized(sum);
      const QVector3D at = millimetres(mesh.vertices_m[corner]);
      corners.push_back({{at.x(), at.y(), at.z()},
                         {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)},
                         {1.0F, 1.0F, 1.0F, 1.0F},
                         {}});
    }
  }
  return corners;
}

QVector3D vectorOf(const QJsonValue& value) {
  const QJsonArray array = value.toArray();
  return {static_cast<float>(array.at(0).toDouble()), static_cast<float>(array.at(1).toDouble()),
          static_cast<float>(array.at(2).toDouble())};
}

InstrumentParts partsOf(const std::filesystem::path& file,
                        const std::function<TriangleMesh(const std::filesystem::path& mesh)>& read) {
  const QJsonObject root = QJsonDocument::fromJson(QByteArray::fromStdString(readFile(file))).object();
  const QJsonObject meshes = root.value(QLatin1String("meshes")).toObject();
  const QJsonObject jaws = root.value(QLatin1String("jaws")).toObject();
  const auto part = [&](const char* name) {
    const std::string mesh = meshes.value(QLatin1String(name)).toString().toStdString();
    // Only beside the file: must not name "../../secret.ply".
    if (mesh.empty() || std::filesystem::path(mesh).filename() != mesh) {
      throw Error(ErrorCode::kBadData, Text::tr("the instrument names no mesh '%1'", name), file.string(),
                  Text::tr("Use the instrument that was installed with the program"));
    }
    return read(file.parent_path() / mesh);
  };
  InstrumentParts parts;
  parts.shaft = part("shaft");
  parts.upperJaw = part("upper_jaw");
  parts.lowerJaw = part("lower_jaw");
  if (meshes.contains(QLatin1String("hand"))) {
    parts.hand = part("hand");
  }
  parts.shaftLength_mm = root.value(QLatin1String("shaft_length_mm")).toDouble(parts.shaftLength_mm);
  parts.jawPivot_mm = vectorOf(jaws.value(QLatin1String("pivot_mm")));
  parts.jawOpening_deg = jaws.value(QLatin1String("opening_deg")).toDouble(parts.jawOpening_deg);
  return parts;
}

}  // namespace

InstrumentParts loadInstrument(const std::filesystem::path& assets, const std::string& id) {
  return partsOf(assets / "instruments" / (id + ".json"), [](const std::filesystem::path& mesh) {
    return importMesh(mesh, {.scale_m = kInstrumentUnit_m, .organ = false});
  });
}

InstrumentParts loadInstrument(const std::filesystem::path& file) {
  return partsOf(file, [](const std::filesystem::path& mesh) {
    return checkedMesh(readMeshApart(mesh, kInstrumentUnit_m).mesh, mesh.string(), {.organ = false});
  });
}

TriangleMesh turnedBody(std::span<const std::array<double, 2>> profile_mm, int sides) {
  TriangleMesh mesh;
  const auto rings = static_cast<std::uint32_t>(profile_mm.size()) - 2;
  const auto around = static_cast<std::uint32_t>(sides);
  const auto point = [](double radius_mm, double angle, double z_mm) {
    return 1e-3 * Vec3{radius_mm * std::cos(angle), radius_mm * std::sin(angle), z_mm};
  };
  mesh.vertices_m.push_back(point(0.0, 0.0, profile_mm.front()[1]));
  for (const std::array<double, 2>& ring : profile_mm.subspan(1, rings)) {
    for (int i = 0; i < sides; ++i) {
      mesh.vertices_m.push_back(point(ring[0], 2.0 * std::numbers::pi * i / sides, ring[1]));
    }
  }
  mesh.vertices_m.push_back(point(0.0, 0.0, profile_mm.back()[1]));
  const auto top = static_cast<std::uint32_t>(mesh.vertices_m.size() - 1);
  for (std::uint32_t i = 0; i < around; ++i) {
    const std::uint32_t here = 1 + i;
    const std::uint32_t next = 1 + (i + 1) % around;
    mesh.triangles.push_back({0, next, here});
    for (std::uint32_t below = 0; below + around < rings * around; below += around) {
      const std::uint32_t above = below + around;
      mesh.triangles.push_back({here + below, next + below, next + above});
      mesh.triangles.push_back({here + below, next + above, here + above});
    }
    const std::uint32_t last = (rings - 1) * around;
    mesh.triangles.push_back({here + last, next + last, top});
  }
  return mesh;
}

InstrumentGeometry::InstrumentGeometry() {
  announceEdgeVertices(*this);
}

void InstrumentGeometry::setMesh(const TriangleMesh& mesh) {
  corners_ = cornersOf(mesh);
  silhouette_ = Silhouette(mesh.triangles, mesh.vertices_m.size());
  constexpr float kHuge = std::numeric_limits<float>::max();
  QVector3D low(kHuge, kHuge, kHuge);
  QVector3D high(-kHuge, -kHuge, -kHuge);
  vertices_mm_.clear();
  for (const Vec3& vertex_m : mesh.vertices_m) {
    const QVector3D at = vertices_mm_.emplace_back(millimetres(vertex_m));
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], at[k]);
      high[k] = std::max(high[k], at[k]);
    }
  }
  setVertexData({reinterpret_cast<const char*>(corners_.data()),
                 static_cast<qsizetype>(corners_.size() * sizeof(EdgeVertex))});
  setBounds(low, high);
  update();
}

void InstrumentGeometry::appendSoftEdge(const QMatrix4x4& place, const QColor& colour, float surface,
                                        const Eye& eye, std::vector<EdgeVertex>& quads) {
  places_.clear();
  for (const QVector3D& vertex_mm : vertices_mm_) {
    places_.push_back(place.map(vertex_mm));
  }
  const QMatrix4x4 turn = place.inverted().transposed();  // for normals, valid under stretching too
  const auto end = [&](const Silhouette::Rim& rim, std::uint32_t side) {
    EdgeVertex vertex = corners_[std::size_t{3} * rim.triangle + side];
    const QVector3D at = places_[silhouette_.triangle(rim.triangle)[side]];
    const QVector3D normal =
        turn.mapVector({vertex.normal[0], vertex.normal[1], vertex.normal[2]}).normalized();
    const float shade[3] = {colour.redF(), colour.greenF(), colour.blueF()};
    for (int k = 0; k < 3; ++k) {
      vertex.position[k] = at[k];
      vertex.normal[k] = normal[k];
      vertex.colour[k] = shade[k];
    }
    vertex.map[0] = surface;
    return vertex;
  };
  for (const Silhouette::Rim& rim : silhouette_.find(places_, eye.position)) {
    const std::uint32_t to = (rim.side + 1) % 3;
    gui::appendSoftEdge(end(rim, rim.side), end(rim, to),
                        silhouette_.outward(silhouette_.triangle(rim.triangle)[rim.side]),
                        silhouette_.outward(silhouette_.triangle(rim.triangle)[to]), eye, quads);
  }
}

}  // namespace torsio::gui
