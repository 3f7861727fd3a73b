// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <QVector3D>

#include "app/gui/scene/moving_geometry.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio::gui {

/// From where a picture is seen.
struct Eye {
  QVector3D position;        ///< view frame, mm
  float pixel_share = 0.0F;  ///< size of a pixel at a distance of one
};

/// One corner of a solid thing or of a soft edge, as the graphics card reads it.
struct EdgeVertex {
  float position[3];  ///< mm
  float normal[3];
  float colour[4];  ///< the fourth: how much of the pixel is covered, 1 at the edge and 0 a pixel beyond it
  float map[2];     ///< place on the painted skin; of a solid thing, its kind of surface
};
static_assert(sizeof(EdgeVertex) == 48, "the layout that is announced to the graphics card");

/// Names the parts of EdgeVertex to a geometry.
void announceEdgeVertices(QQuick3DGeometry& geometry);

/// Where a surface turns away from the viewer. Steps of pixels are seen there and nowhere else, so that a
/// soft edge of one pixel along it smooths the picture. Plain value; one thread.
class Silhouette {
 public:
  /// A side of a triangle that faces the viewer, beyond which the surface faces away or ends.
  struct Rim {
    std::uint32_t triangle = 0;
    std::uint32_t side = 0;  ///< from this corner, 0 to 2, to the next
  };

  Silhouette() = default;
  Silhouette(std::span<const TriangleMesh::Triangle> triangles, std::size_t vertices);

  /// `places`: one a vertex. What is returned lives until the next call.
  std::span<const Rim> find(std::span<const QVector3D> places, const QVector3D& eye);
  /// At a vertex of the rim that was found: away from the surface, across the line of sight; unit.
  [[nodiscard]] QVector3D outward(std::uint32_t vertex) const { return outward_[vertex].normalized(); }
  [[nodiscard]] const TriangleMesh::Triangle& triangle(std::uint32_t index) const {
    return triangles_[index];
  }

 private:
  struct Side {
    Rim rim;
    Rim other;          // the same side, of the triangle beyond
    bool last = false;  // nothing is beyond
  };
  void add(std::span<const QVector3D> places, const QVector3D& eye, const Rim& seen);

  std::vector<TriangleMesh::Triangle> triangles_;
  std::vector<Side> sides_;
  std::vector<std::uint8_t> faces_;  // one a triangle: 1 towards the viewer
  std::vector<QVector3D> outward_;   // one a vertex, sums
  std::vector<Rim> rims_;
};

/// Adds the soft edge along a rim, four corners: the two of the rim as they are drawn, and the same a pixel
/// further out.
void appendSoftEdge(const EdgeVertex& from, const EdgeVertex& to, const QVector3D& outwardFrom,
                    const QVector3D& outwardTo, const Eye& eye, std::vector<EdgeVertex>& quads);

/// Soft edges as the graphics card draws them. GUI thread.
class OutlineGeometry : public MovingGeometry {
  Q_OBJECT

 public:
  OutlineGeometry();
  /// Four corners a quad.
  void setQuads(std::span<const EdgeVertex> corners);

 private:
  std::vector<EdgeVertex> drawn_;  // with room: as many corners as the triangles name
};

}  // namespace torsio::gui
