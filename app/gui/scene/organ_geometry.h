// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <QQuick3DTextureData>

#include "app/gui/scene/moving_geometry.h"
#include "app/gui/scene/organ_surface.h"
#include "app/gui/scene/outline.h"
#include "sim/scene/skin/tissue_skin.h"

namespace torsio::gui {

/// A vertex as sent to the graphics card. The first three attributes move with the tissue, the others never
/// change.
struct DrawnVertex {
  float position[3];  ///< view frame, mm
  float normal[3];
  float colour[4];  ///< linear
  float map[2];     ///< position on the painted skin, 0..1
  float along[2];   ///< mm along the organ; number of the vertex of the organ's mesh
  float rest[3];    ///< rest position, view frame, mm; passed as the tangent
};
static_assert(sizeof(DrawnVertex) == 68, "the layout that OrganGeometry announces");

/// The organ's skin in the scene graph; its vertices are rewritten when the tissue moves. GUI thread.
class OrganGeometry : public MovingGeometry {
  Q_OBJECT

 public:
  OrganGeometry();
  /// Sets another organ's triangles and vertices. Without a skin, nothing is painted.
  void setSurface(const OrganSurface& surface, const TissueSkin* skin = nullptr);
  /// Moves the vertices of the present organ.
  void updateVertices(const OrganSurface& surface);
  /// Sets what covers the colour of the tissue, of an organ that a shader moves: one per vertex, sRGB times
  /// how far it covers, and what shows through (BloodMap::cover).
  void setCovers(std::span<const std::array<float, 4>> covers);
  /// Sets the space that the organ takes, of one that a shader moves, from some of its vertices.
  void setReach(const OrganSurface& surface, std::span<const std::uint32_t> some);
  /// Returns the soft edge of the organ after its last update; valid until the next call.
  std::span<const EdgeVertex> softEdge(const OrganSurface& surface, const Eye& eye);

 private:
  std::vector<DrawnVertex> drawn_;
  std::vector<TriangleMesh::Triangle> corners_;  // indices of drawn vertices, in the order of the surface
  Silhouette silhouette_;
  std::vector<QVector3D> places_;
  std::vector<EdgeVertex> edge_;
  std::vector<std::uint32_t> sources_;  // surface vertex of each drawn vertex
};

/// The painted skin as a texture. GUI thread.
class SkinTexture : public QQuick3DTextureData {
  Q_OBJECT

 public:
  void setSkin(const TissueSkin& skin);
};

/// Numbers for a vertex shader, as a texture. GUI thread.
class NumberTexture : public QQuick3DTextureData {
  Q_OBJECT

 public:
  /// Sets numbers in lines of `wide` texels of four, or of one; the last line is filled up.
  void setTexels(std::span<const std::array<float, 4>> texels, int wide);
  void setNumbers(std::span<const float> numbers, int wide);

 protected:
  QSSGRenderGraphObject* updateSpatialNode(QSSGRenderGraphObject* node) override;

 private:
  void fill(const float* numbers, std::size_t texels, std::size_t each, int wide);
};

/// The organ's edges as thin lines, raised above the skin to avoid flicker. GUI thread.
class WireGeometry : public MovingGeometry {
  Q_OBJECT

 public:
  WireGeometry();
  void setSurface(const OrganSurface& surface);
  void updateVertices(const OrganSurface& surface);
};

}  // namespace torsio::gui
