// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/gui/scene/lattice_overlay.h"
#include "app/gui/scene/markers.h"
#include "app/gui/scene/mesentery.h"
#include "app/gui/scene/organ_surface.h"
#include "app/gui/scene/shear_map.h"
#include "app/gui/scene/surroundings.h"
#include "sim/core/vec3.h"
#include "sim/scene/blood_map.h"
#include "sim/scene/organ_state.h"
#include "sim/scene/skin/tissue_skin.h"
#include "sim/scene/tissue_look.h"

namespace torsio::gui {

/// What the view draws for one organ; made once beside the loading.
struct ViewScene {
  OrganSurface surface;
  std::shared_ptr<const TissueSkin> skin;  ///< null where no scene can be drawn
  LatticeLines lines;
  TissueLook look;
  Surroundings surroundings = Surroundings::kDrape;
  ShearMap shear;                        ///< empty: no map can be shown
  BloodMap blood;                        ///< empty: the tissue keeps its colour
  std::vector<MesenteryHold> mesentery;  ///< of Surroundings::kBowelLoop; empty: none is drawn
  std::vector<SkinAnchor> markers;       ///< empty: the organ has none
  /// The vertices for a state of twist, one a vertex of the surface, metres. GUI thread.
  std::function<void(const OrganState&, std::span<Vec3>)> deform;
  /// Where an asynchronous model answers: the number of its newest shape, 0 before the first, and the
  /// vertices of that shape. GUI thread. Empty: `deform` tells all.
  std::function<std::int64_t()> shapeNumber;
  std::function<void(std::span<Vec3>)> shape;
};

/// Surface, overlay lines and colours of a scene. Slow (fractions of a second); asks scene->collision, so
/// call it before the servo runs.
/// `tissue`: name by which the look is chosen, empty: the scene's id.
[[nodiscard]] ViewScene makeViewScene(const std::shared_ptr<const Scene>& scene,
                                      const std::string& tissue = {});

}  // namespace torsio::gui
