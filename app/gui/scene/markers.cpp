// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/markers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <QByteArray>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "sim/core/error.h"
#include "sim/scene/scene_file.h"

namespace torsio::gui {

namespace {

constexpr double kMetresPerMillimetre = 0.001;

// Corners and faces of an icosahedron, which looks like a ball when small and unshaded.
constexpr float kGolden = 1.6180340F;
constexpr std::array<std::array<float, 3>, 12> kCorners{{{-1, kGolden, 0},
                                                         {1, kGolden, 0},
                                                         {-1, -kGolden, 0},
                                                         {1, -kGolden, 0},
                                                         {0, -1, kGolden},
                                                         {0, 1, kGolden},
                                                         {0, -1, -kGolden},
                                                         {0, 1, -kGolden},
                                                         {kGolden, 0, -1},
                                                         {kGolden, 0, 1},
                                                         {-kGolden, 0, -1},
                                                         {-kGolden, 0, 1}}};
constexpr std::array<std::uint32_t, 60> kFaces{
    0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4,  11, 10, 2,  10, 7, 6, 7, 1, 8,
    3, 9,  4, 3, 4, 2, 3, 2, 6, 3, 6, 8,  3, 8,  9,  4, 9, 5, 2, 4,  11, 6,  2,  10, 8,  6, 7, 9, 8, 1};
const float kCornerDistance = std::sqrt(1.0F + kGolden * kGolden);

using Attribute = QQuick3DGeometry::Attribute;

}  // namespace

std::vector<SkinAnchor> organMarkers(const Scene& scene, const std::filesystem::path& assets) {
  const std::filesystem::path path = organMarkersFile(assets, scene);
  QFile file(QString::fromStdString(path.string()));
  if (!file.open(QIODevice::ReadOnly)) {
    return {};
  }
  const QJsonArray entries =
      QJsonDocument::fromJson(file.readAll()).object()[QLatin1String("markers")].toArray();
  std::vector<SkinAnchor> markers;
  for (const QJsonValue& entry : entries) {
    const QJsonArray place_mm = entry.toObject()[QLatin1String("position_mm")].toArray();
    if (place_mm.size() != 3) {
      throw Error(ErrorCode::kBadData, Text::tr("a marker has no position of three numbers"), path.string(),
                  Text::tr("Correct the file, or remove it"));
    }
    const Vec3 place_m{place_mm[0].toDouble() * kMetresPerMillimetre,
                       place_mm[1].toDouble() * kMetresPerMillimetre,
                       place_mm[2].toDouble() * kMetresPerMillimetre};
    markers.push_back(skinAnchor(scene, place_m));
  }
  return markers;
}

QVector3D markerPlace(const SkinAnchor& marker, const OrganSurface& surface) {
  QVector3D place;
  for (std::size_t k = 0; k < 3; ++k) {
    const SurfaceVertex& v = surface.vertices()[marker.corners[k]];
    place += marker.weights[k] * QVector3D(v.position[0], v.position[1], v.position[2]);
  }
  return place;
}

MarkerGeometry::MarkerGeometry() {
  setStride(3 * sizeof(float));
  setPrimitiveType(PrimitiveType::Triangles);
  addAttribute(Attribute::PositionSemantic, 0, Attribute::F32Type);
  addAttribute(Attribute::IndexSemantic, 0, Attribute::U32Type);
}

void MarkerGeometry::setMarkers(const std::vector<QVector3D>& centres, float radius_mm) {
  std::vector<float> vertices;
  std::vector<std::uint32_t> indices;
  QVector3D low = centres.empty() ? QVector3D() : centres.front();
  QVector3D high = low;
  const float scale = radius_mm / kCornerDistance;
  for (const QVector3D& centre : centres) {
    const auto first = static_cast<std::uint32_t>(vertices.size() / 3);
    for (const std::array<float, 3>& corner : kCorners) {
      for (int k = 0; k < 3; ++k) {
        vertices.push_back(centre[k] + scale * corner[static_cast<std::size_t>(k)]);
      }
    }
    for (const std::uint32_t index : kFaces) {
      indices.push_back(first + index);
    }
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], centre[k] - radius_mm);
      high[k] = std::max(high[k], centre[k] + radius_mm);
    }
  }
  setVertexData({reinterpret_cast<const char*>(vertices.data()),
                 static_cast<qsizetype>(vertices.size() * sizeof(float))});
  setIndexData({reinterpret_cast<const char*>(indices.data()),
                static_cast<qsizetype>(indices.size() * sizeof(std::uint32_t))});
  setBounds(low, high);
  update();
}

}  // namespace torsio::gui
