// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/skin_overlays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include <QByteArray>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "sim/core/error.h"
#include "sim/scene/scene_file.h"

namespace torsio::gui {

namespace {

constexpr double kStep_m = 0.0025;  // maximum length of a line segment before projection onto the skin
constexpr float kLift_mm = 0.35F;   // above the skin, because chords of a curved surface run below it

using Attribute = QQuick3DGeometry::Attribute;

/// Subdivides a polyline and projects it onto the skin.
SkinLine skinLine(const Scene& scene, std::span<const Vec3> corners_m, bool closed) {
  SkinLine line;
  line.closed = closed;
  const std::size_t pieces = closed ? corners_m.size() : corners_m.size() - 1;
  for (std::size_t i = 0; i < pieces; ++i) {
    const Vec3& a = corners_m[i];
    const Vec3& b = corners_m[(i + 1) % corners_m.size()];
    const int steps = std::max(1, static_cast<int>(std::ceil(norm(b - a) / kStep_m)));
    for (int k = 0; k < steps; ++k) {
      line.anchors.push_back(skinAnchor(scene, a + (b - a) * (double(k) / steps)));
    }
  }
  if (!closed) {
    line.anchors.push_back(skinAnchor(scene, corners_m.back()));
  }
  return line;
}

SkinLine graspLine(const Scene& scene) {
  const SectionLattice& lattice = scene.lattice();
  const double position = std::clamp(scene.pattern.graspArc, 0.0, 1.0) * (lattice.sections() - 1);
  const int below = std::min(static_cast<int>(position), lattice.sections() - 2);
  const double t = position - below;
  std::vector<Vec3> corners;
  corners.reserve(static_cast<std::size_t>(lattice.ridges()));
  for (int ridge = 0; ridge < lattice.ridges(); ++ridge) {
    corners.push_back(lattice.keyPoint_m(ridge, below) * (1.0 - t) +
                      lattice.keyPoint_m(ridge, below + 1) * t);
  }
  return skinLine(scene, corners, true);
}

struct SkinPlace {
  QVector3D position;
  QVector3D normal;
};

SkinPlace placeOf(const SkinAnchor& anchor, std::span<const SurfaceVertex> vertices) {
  SkinPlace place;
  for (std::size_t k = 0; k < 3; ++k) {
    const SurfaceVertex& v = vertices[anchor.corners[k]];
    place.position += anchor.weights[k] * QVector3D(v.position[0], v.position[1], v.position[2]);
    place.normal += anchor.weights[k] * QVector3D(v.normal[0], v.normal[1], v.normal[2]);
  }
  place.normal.normalize();
  return place;
}

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

SkinAnchor skinAnchor(const Scene& scene, const Vec3& point_m) {
  const SurfacePoint hit = scene.collision.closest(point_m);
  SkinAnchor anchor;
  anchor.corners = scene.mesh.triangles[hit.triangle];
  for (std::size_t k = 0; k < 3; ++k) {
    anchor.weights[k] = static_cast<float>(hit.barycentric[k]);
  }
  return anchor;
}

LatticeLines latticeLines(const Scene& scene) {
  const SectionLattice& lattice = scene.lattice();
  LatticeLines lines;
  std::vector<Vec3> corners;
  for (int ridge = 0; ridge < lattice.ridges(); ++ridge) {
    corners.clear();
    for (int j = 0; j < lattice.sections(); ++j) {
      corners.push_back(lattice.keyPoint_m(ridge, j));
    }
    lines.lattice.push_back(skinLine(scene, corners, false));
  }
  for (int j = 0; j < lattice.sections(); ++j) {
    corners.clear();
    for (int ridge = 0; ridge < lattice.ridges(); ++ridge) {
      corners.push_back(lattice.keyPoint_m(ridge, j));
    }
    lines.lattice.push_back(skinLine(scene, corners, true));
  }
  lines.grasp.push_back(graspLine(scene));
  return lines;
}

RibbonGeometry::RibbonGeometry() {
  setStride(3 * sizeof(float));
  setPrimitiveType(PrimitiveType::Triangles);
  addAttribute(Attribute::PositionSemantic, 0, Attribute::F32Type);
  addAttribute(Attribute::IndexSemantic, 0, Attribute::U32Type);
}

void RibbonGeometry::setLines(std::vector<SkinLine> lines, float width_mm, const OrganSurface& surface,
                              Shape shape) {
  lines_ = std::move(lines);
  strips_ = shape == Shape::kStanding ? 2 : 1;
  halfWidth_mm_ = 0.5F * width_mm;
  std::vector<std::uint32_t> indices;
  std::uint32_t first = 0;
  for (const SkinLine& line : lines_) {
    const auto count = static_cast<std::uint32_t>(line.anchors.size());
    const std::uint32_t pieces = line.closed ? count : count - 1;
    const std::uint32_t corners = 2 * strips_;
    for (std::uint32_t i = 0; i < pieces * strips_; ++i) {
      const std::uint32_t strip = first + 2 * (i / pieces);
      const std::uint32_t a = strip + corners * (i % pieces);
      const std::uint32_t b = strip + corners * ((i % pieces + 1) % count);
      indices.insert(indices.end(), {a, a + 1, b, b, a + 1, b + 1});
    }
    first += corners * count;
  }
  setIndexData({reinterpret_cast<const char*>(indices.data()),
                static_cast<qsizetype>(indices.size() * sizeof(std::uint32_t))});
  reshape();
  follow(surface);
}

void RibbonGeometry::follow(const OrganSurface& surface) {
  constexpr float kHuge = std::numeric_limits<float>::max();
  QVector3D low(kHuge, kHuge, kHuge);
  QVector3D high(-kHuge, -kHuge, -kHuge);
  std::size_t points = 0;
  for (const SkinLine& line : lines_) {
    points += line.anchors.size();
  }
  QByteArray bytes(static_cast<qsizetype>(points * strips_ * 6 * sizeof(float)), Qt::Uninitialized);
  auto* out = reinterpret_cast<float*>(bytes.data());
  std::vector<SkinPlace> places;
  for (const SkinLine& line : lines_) {
    places.clear();
    for (const SkinAnchor& anchor : line.anchors) {
      places.push_back(placeOf(anchor, surface.vertices()));
    }
    const std::size_t count = places.size();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t before = i > 0 ? i - 1 : (line.closed ? count - 1 : 0);
      const std::size_t after = i + 1 < count ? i + 1 : (line.closed ? 0 : i);
      const QVector3D along = places[after].position - places[before].position;
      const QVector3D side = QVector3D::crossProduct(along, places[i].normal).normalized() * halfWidth_mm_;
      const QVector3D centre = places[i].position + kLift_mm * places[i].normal;
      const QVector3D top = centre + 2.0F * halfWidth_mm_ * places[i].normal;
      const std::array<QVector3D, 4> ends{centre - side, centre + side, places[i].position, top};
      for (const QVector3D& p : std::span(ends).first(2 * strips_)) {
        for (int k = 0; k < 3; ++k) {
          *out++ = p[k];
          low[k] = std::min(low[k], p[k]);
          high[k] = std::max(high[k], p[k]);
        }
      }
    }
  }
  setVertexData(bytes);
  if (points > 0) {
    setBounds(low, high);
  }
  update();
}

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
