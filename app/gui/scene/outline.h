// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <QVector3D>

#include "app/gui/scene/moving_geometry.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio::gui {

/// The viewpoint of a picture.
struct Eye {
  QVector3D position;        ///< view frame, mm
  float pixel_share = 0.0F;  ///< size of a pixel at unit distance
};

/// A vertex of a solid or a soft edge as sent to the graphics card.
struct EdgeVertex {
  float position[3];  ///< mm
  float normal[3];
  float colour[4];  ///< the fourth is the coverage, 1 at the edge and 0 one pixel beyond it
  float map[2];     ///< position on the painted skin; for solids, the surface kind
};
static_assert(sizeof(EdgeVertex) == 48, "the layout that is announced to the graphics card");

/// Declares the attributes of EdgeVertex to a geometry.
void announceEdgeVertices(QQuick3DGeometry& geometry);

/// The rim where a surface turns away from the viewer. Aliasing is visible only there, so that a soft edge of
/// one pixel along it smooths the picture. Plain value; use from one thread.
class Silhouette {
 public:
  /// An edge of a triangle facing the viewer, beyond which the surface faces away or ends.
  struct Rim {
    std::uint32_t triangle = 0;
    std::uint32_t side = 0;  ///< from this corner, 0 to 2, to the next
  };

  Silhouette() = default;
  Silhouette(std::span<const TriangleMesh::Triangle> triangles, std::size_t vertices);

  /// `places`: one per vertex. The result is valid until the next call.
  std::span<const Rim> find(std::span<const QVector3D> places, const QVector3D& eye);
  /// Returns the unit vector away from the surface and across the line of sight, at a vertex of the rim
  /// found.
  [[nodiscard]] QVector3D outward(std::uint32_t vertex) const { return outward_[vertex].normalized(); }
  [[nodiscard]] const TriangleMesh::Triangle& triangle(std::uint32_t index) const {
    return triangles_[index];
  }

 private:
  struct Side {
    Rim rim;
    Rim other;          // the same edge in the triangle beyond
    bool last = false;  // no triangle beyond
  };
  void add(std::span<const QVector3D> places, const QVector3D& eye, const Rim& seen);

  std::vector<TriangleMesh::Triangle> triangles_;
  std::vector<Side> sides_;
  std::vector<std::uint8_t> faces_;  // one per triangle; 1: faces the viewer
  std::vector<QVector3D> outward_;   // one per vertex, sums
  std::vector<Rim> rims_;
};

/// Adds the soft edge along an edge of the rim as four corners: its two ends, and both a pixel further out.
void appendSoftEdge(const EdgeVertex& from, const EdgeVertex& to, const QVector3D& outwardFrom,
                    const QVector3D& outwardTo, const Eye& eye, std::vector<EdgeVertex>& quads);

/// Soft edges as a mesh. GUI thread.
class OutlineGeometry : public MovingGeometry {
  Q_OBJECT

 public:
  OutlineGeometry();
  /// Four corners per quad.
  void setQuads(std::span<const EdgeVertex> corners);

 private:
  std::vector<EdgeVertex> drawn_;  // with spare room: as many corners as the triangles use
};

}  // namespace torsio::gui
