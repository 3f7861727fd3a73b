// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include <QQuick3DGeometry>
#include <QVector3D>

#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio::gui {

/// The bodies of an instrument of assets/instruments in its own frame: tip at the origin, shaft along +z.
struct InstrumentParts {
  TriangleMesh shaft;
  TriangleMesh upperJaw;
  TriangleMesh lowerJaw;
  TriangleMesh hand;  ///< gloved, about the end of the shaft; empty: the instrument has none
  QVector3D jawPivot_mm;
  double shaftLength_mm = 250.0;
  double jawOpening_deg = 20.0;  ///< each jaw, fully open
};

/// Throws Error{kFileMissing, kFileUnreadable, kBadData} for files that are absent or not an instrument.
[[nodiscard]] InstrumentParts loadInstrument(const std::filesystem::path& assets, const std::string& id);

/// One rigid body of the instrument; edges sharper than 35 degrees stay sharp. GUI thread.
class InstrumentGeometry : public QQuick3DGeometry {
  Q_OBJECT

 public:
  InstrumentGeometry();
  void setMesh(const TriangleMesh& mesh);
};

}  // namespace torsio::gui
