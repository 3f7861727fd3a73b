// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "app/gui/scene/view_scene.h"
#include "app/services/base/progress.h"
#include "sim/imaging/surface/scan_preview.h"
#include "sim/scene/organ_import.h"
#include "sim/scene/organ_reconstruction.h"

namespace torsio::gui {

/// A place of an organ that is worth pointing at.
struct OrganLandmark {
  enum class Kind { kFixedEnd, kFreeEnd, kWidest, kNarrowest };
  Kind kind = Kind::kFixedEnd;
  Vec3 place_m;  ///< on its axis, at rest
};

/// An organ that was judged, and what is looked at to see whether the judgement is right.
struct OrganTrial {
  OrganImport import;
  std::shared_ptr<const Scene> scene;         ///< twists about its own axis; null: it has no axis
  std::shared_ptr<const TriangleMesh> shown;  ///< the surface in the view; empty: none could be mended
  ViewScene view;
  std::vector<Vec3> axis_m;  ///< from the held to the free end; empty: none
  std::vector<OrganLandmark> landmarks;
};

/// Reads a mesh, judges it and makes what is looked at. Slow (seconds): in a worker thread. `progress` may
/// throw to give up. Throws as importOrgan().
[[nodiscard]] OrganTrial trialOfMesh(const OrganImportRequest& request, const ProgressCallback& progress);

/// Reads a scan apart and makes it small enough to look at, with `find` also the organ in it. As trialOfMesh.
/// Throws as previewApart().
[[nodiscard]] ScanPreview previewOf(const ScanRequest& scan, bool find, const ProgressCallback& progress);

/// Draws the organ of a scan, judges it and makes what is looked at; `surface`: as it was drawn. As
/// trialOfMesh. Throws as reconstructOrgan().
[[nodiscard]] OrganTrial trialOfScan(const OrganImportRequest& request, const ScanRequest& scan,
                                     ScanSurface& surface, const ProgressCallback& progress);

/// Judges a surface anew that was drawn from a scan before.
[[nodiscard]] OrganTrial trialOfSurface(const OrganImportRequest& request, const ScanRequest& scan,
                                        const ScanSurface& surface, const ProgressCallback& progress);

/// Makes what is looked at of an organ that was judged. `assets`: the assets folder.
[[nodiscard]] OrganTrial trialOf(OrganImport import, const std::filesystem::path& assets);

}  // namespace torsio::gui
