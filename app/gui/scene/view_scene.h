// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/gui/scene/continuation.h"
#include "app/gui/scene/mesentery.h"
#include "app/gui/scene/organ_surface.h"
#include "app/gui/scene/shear_map.h"
#include "app/gui/scene/skin_overlays.h"
#include "app/gui/scene/surroundings.h"
#include "sim/core/vec3.h"
#include "sim/scene/blood_map.h"
#include "sim/scene/organ_state.h"
#include "sim/scene/shader_skin.h"
#include "sim/scene/skin/tissue_skin.h"
#include "sim/scene/tissue_look.h"

namespace torsio::gui {

/// The drawing data of an organ, created while loading.
struct ViewScene {
  OrganSurface surface;
  std::shared_ptr<const TissueSkin> skin;  ///< null if scenes cannot be drawn
  LatticeLines lines;
  TissueLook look;
  Surroundings surroundings = Surroundings::kDrape;
  ShearMap shear;                           ///< empty: no shear map
  BloodMap blood;                           ///< empty: constant tissue colour
  std::vector<MesenteryHold> mesentery;     ///< for Surroundings::kBowelLoop; otherwise empty
  std::vector<Continuation> continuations;  ///< of a stomach with its own open ends; otherwise empty
  std::vector<SkinAnchor> markers;          ///< empty if the organ has none
  std::shared_ptr<ShaderSkin> shader;       ///< null if no vertex shader can deform the organ
  /// Computes the vertices for a state of twist, one per vertex of the surface, metres. GUI thread.
  std::function<void(const OrganState&, std::span<Vec3>)> deform;
  /// For an asynchronous model: number of its latest shape, 0 before the first, and that shape's vertices.
  /// GUI thread. Empty: only `deform` is used.
  std::function<std::int64_t()> shapeNumber;
  std::function<void(std::span<Vec3>)> shape;
};

/// Creates surface, overlay lines and colours of a scene. Slow (fractions of a second); uses
/// scene->collision, so call it before the servo runs. `tissue`: name that selects the look; empty: the
/// scene's id.
[[nodiscard]] ViewScene makeViewScene(const std::shared_ptr<const Scene>& scene,
                                      const std::string& tissue = {});

}  // namespace torsio::gui
