// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/instrument_geometry.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include <QByteArray>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "sim/base/error.h"
#include "sim/base/file_io.h"
#include "sim/geometry/mesh/mesh_import.h"

namespace torsio::gui {

namespace {

using Attribute = QQuick3DGeometry::Attribute;

constexpr double kSharpEdgeCosine = 0.819;  // 35 degrees
constexpr float kMillimetres = 1000.0F;

struct Corner {
  QVector3D position;
  QVector3D normal;
};

QVector3D millimetres(const Vec3& p) {
  return QVector3D(static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)) * kMillimetres;
}

/// Three corners a triangle; each takes the mean of those normals round its vertex that look nearly its way.
std::vector<Corner> cornersOf(const TriangleMesh& mesh) {
  std::vector<Vec3> faces;
  std::vector<std::vector<std::uint32_t>> around(mesh.vertices_m.size());
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.vertices_m[t[0]];
    for (const std::uint32_t corner : t) {
      around[corner].push_back(static_cast<std::uint32_t>(faces.size()));
    }
    faces.push_back(cross(mesh.vertices_m[t[1]] - a, mesh.vertices_m[t[2]] - a));  // weighs by area
  }
  std::vector<Corner> corners;
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
      corners.push_back(
          {millimetres(mesh.vertices_m[corner]),
           QVector3D(static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z))});
    }
  }
  return corners;
}

QVector3D vectorOf(const QJsonValue& value) {
  const QJsonArray array = value.toArray();
  return {static_cast<float>(array.at(0).toDouble()), static_cast<float>(array.at(1).toDouble()),
          static_cast<float>(array.at(2).toDouble())};
}

}  // namespace

InstrumentParts loadInstrument(const std::filesystem::path& assets, const std::string& id) {
  const std::filesystem::path folder = assets / "instruments";
  const std::filesystem::path file = folder / (id + ".json");
  const QJsonObject root = QJsonDocument::fromJson(QByteArray::fromStdString(readFile(file))).object();
  const QJsonObject meshes = root.value(QLatin1String("meshes")).toObject();
  const QJsonObject jaws = root.value(QLatin1String("jaws")).toObject();
  const auto part = [&](const char* name) {
    const std::string mesh = meshes.value(QLatin1String(name)).toString().toStdString();
    if (mesh.empty()) {
      throw Error(ErrorCode::kBadData, Text::tr("the instrument names no mesh '%1'", name), file.string(),
                  Text::tr("Take the instrument that was installed with the program"));
    }
    return importMesh(folder / mesh, {.scale_m = 0.001, .organ = false});
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

InstrumentGeometry::InstrumentGeometry() {
  static_assert(sizeof(Corner) == 6 * sizeof(float));
  setStride(sizeof(Corner));
  setPrimitiveType(PrimitiveType::Triangles);
  addAttribute(Attribute::PositionSemantic, 0, Attribute::F32Type);
  addAttribute(Attribute::NormalSemantic, 3 * sizeof(float), Attribute::F32Type);
}

void InstrumentGeometry::setMesh(const TriangleMesh& mesh) {
  const std::vector<Corner> corners = cornersOf(mesh);
  constexpr float kHuge = std::numeric_limits<float>::max();
  QVector3D low(kHuge, kHuge, kHuge);
  QVector3D high(-kHuge, -kHuge, -kHuge);
  for (const Corner& corner : corners) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], corner.position[k]);
      high[k] = std::max(high[k], corner.position[k]);
    }
  }
  setVertexData({reinterpret_cast<const char*>(corners.data()),
                 static_cast<qsizetype>(corners.size() * sizeof(Corner))});
  setBounds(low, high);
  update();
}

}  // namespace torsio::gui
