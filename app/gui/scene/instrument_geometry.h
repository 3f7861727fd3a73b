// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <QColor>
#include <QMatrix4x4>
#include <QQuick3DGeometry>
#include <QVector3D>

#include "app/gui/scene/outline.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio::gui {

/// The bodies of an instrument of assets/instruments in its own frame: tip at the origin, shaft along +z.
struct InstrumentParts {
  TriangleMesh shaft;
  TriangleMesh upperJaw;
  TriangleMesh lowerJaw;
  TriangleMesh hand;  ///< gloved hand at the end of the shaft; empty: none
  QVector3D jawPivot_mm;
  double shaftLength_mm = 250.0;
  double jawOpening_deg = 20.0;  ///< of each jaw, fully open
};

/// Reads a shipped instrument, or a centre's own (NAME.json) with its meshes in the same folder. Throws
/// Error{kFileMissing, kFileUnreadable, kBadData, kBadMesh} for missing or invalid files.
[[nodiscard]] InstrumentParts loadInstrument(const std::filesystem::path& assets, const std::string& id);
[[nodiscard]] InstrumentParts loadInstrument(const std::filesystem::path& file);

/// Returns a closed body of revolution about z; `profile_mm`: radius and z, from one end on the axis to the
/// other, in order of z.
[[nodiscard]] TriangleMesh turnedBody(std::span<const std::array<double, 2>> profile_mm, int sides);

/// A rigid body of the instrument; edges sharper than 35 degrees stay sharp. GUI thread.
class InstrumentGeometry : public QQuick3DGeometry {
  Q_OBJECT

 public:
  InstrumentGeometry();
  void setMesh(const TriangleMesh& mesh);
  /// Adds the soft edge of the body at `place`. `surface`: the material's surface kind.
  void appendSoftEdge(const QMatrix4x4& place, const QColor& colour, float surface, const Eye& eye,
                      std::vector<EdgeVertex>& quads);

 private:
  std::vector<EdgeVertex> corners_;  // three per triangle
  std::vector<QVector3D> vertices_mm_;
  Silhouette silhouette_;
  std::vector<QVector3D> places_;
};

}  // namespace torsio::gui
