// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "app/gui/scene/view_scene.h"
#include "app/services/base/progress.h"
#include "sim/imaging/surface/scan_preview.h"
#include "sim/scene/organ_import.h"
#include "sim/scene/rod_organ.h"

namespace torsio::gui {

/// A notable place of an organ.
struct OrganLandmark {
  enum class Kind { kFixedEnd, kFreeEnd, kWidest, kNarrowest };
  Kind kind = Kind::kFixedEnd;
  Vec3 place_m;  ///< on the axis, at rest
};

/// A judged organ, with its view for checking the judgement.
struct OrganTrial {
  OrganImport import;
  std::shared_ptr<const Scene> scene;  ///< twists about its own axis; null: no axis
  std::vector<TaskPoint> forth;        ///< of a rod, to either side
  std::vector<TaskPoint> back;
  std::shared_ptr<const TriangleMesh> shown;  ///< surface in the view; empty: could not be repaired
  ViewScene view;
  std::vector<Vec3> axis_m;  ///< from the fixed to the free end; empty: none
  std::vector<OrganLandmark> landmarks;

  /// Returns how the organ lies when it is turned by an angle, as far as it goes.
  [[nodiscard]] OrganState stateAt(double angle_rad) const;
};

/// Reads and judges a mesh and prepares its view. Slow (seconds): in a worker thread. `progress` may throw to
/// cancel. Throws like importOrgan().
[[nodiscard]] OrganTrial trialOfMesh(const OrganImportRequest& request, const ProgressCallback& progress);

/// Reads a scan in a separate process and reduces it for display; `find`: also segments the organ. Threading
/// like trialOfMesh(). Throws like previewApart().
[[nodiscard]] ScanPreview previewOf(const ScanRequest& scan, bool find, const ProgressCallback& progress);

/// Reconstructs and judges the organ of a scan and prepares its view; `surface` receives the reconstruction.
/// Threading like trialOfMesh(). Throws like reconstructOrgan().
[[nodiscard]] OrganTrial trialOfScan(const OrganImportRequest& request, const ScanRequest& scan,
                                     ScanSurface& surface, const ProgressCallback& progress);

/// Judges an existing surface of a scan again.
[[nodiscard]] OrganTrial trialOfSurface(const OrganImportRequest& request, const ScanRequest& scan,
                                        const ScanSurface& surface, const ProgressCallback& progress);

/// Prepares the view of a judged organ. `assets`: the assets folder.
[[nodiscard]] OrganTrial trialOf(OrganImport import, const std::filesystem::path& assets);

}  // namespace torsio::gui
