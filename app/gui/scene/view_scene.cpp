// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/view_scene.h"

#include "app/gui/scene/scene_canvas.h"
#include "sim/scene/hollow_view.h"

namespace torsio::gui {

ViewScene makeViewScene(const std::shared_ptr<const Scene>& scene, const std::string& tissue) {
  ViewScene view;
  const std::string& tissueId = tissue.empty() ? scene->id : tissue;
  view.look = tissueLook(tissueId);
  view.surroundings = surroundingsOf(tissueId, scene->former);
  view.surface = OrganSurface(scene->mesh);
  if (SceneCanvas::platformCanRender()) {
    view.skin = std::make_shared<const TissueSkin>(paintSkin(*scene, view.look));
  }
  view.lines = latticeLines(*scene);
  view.shear = ShearMap(scene);
  view.blood = BloodMap(scene);
  const bool asynchronous = scene->tissue != TissueModel::kTwist;
  if (SceneCanvas::platformCanRender() && !asynchronous) {
    if (std::optional<ShaderSkin> skin =
            ShaderSkin::of(scene, view.blood.empty() ? std::vector<float>{} : view.blood.fed())) {
      view.shader = std::make_shared<ShaderSkin>(std::move(*skin));
    }
  }
  if (view.surroundings == Surroundings::kStomach) {
    view.continuations = stomachContinuations(*scene);
  }
  if (view.surroundings == Surroundings::kBowelLoop || view.surroundings == Surroundings::kClosedLoop) {
    view.mesentery = mesenteryHolds(*scene);
  }
  view.deform = [scene](const OrganState& state, std::span<Vec3> out_m) { scene->deform(state, out_m); };
  if (scene->hollow) {
    view.deform = [drawn = std::make_shared<HollowView>(scene)](
                      const OrganState& state, std::span<Vec3> out_m) { drawn->deform(state, out_m); };
  }
  return view;
}

}  // namespace torsio::gui
