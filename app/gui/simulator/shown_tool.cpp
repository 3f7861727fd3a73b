// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/simulator/shown_tool.h"

#include <optional>

#include "app/gui/scene/scene_view.h"
#include "sim/core/angle.h"
#include "sim/core/organ_pose.h"
#include "sim/scene/scene.h"
#include "sim/servo/surface_proxy.h"

namespace torsio::gui {

namespace {

constexpr double kLeanWithin_m = 0.040;
constexpr double kLag_rad = radians(10.0);  // maximum lag of the organ behind the keys

}  // namespace

LiveState ShownTool::show(const LiveState& state) {
  const bool holds = state.phase == ExercisePhase::kTwisting;
  const bool rides = controller_.toolRidesOnTissue();
  std::optional<Vec3> axis;
  if (holds && rides && controller_.playback() == nullptr) {
    axis = controller_.scene()->graspFrame(state.response.graspArc_m, state.tool.position_m).tangent;
  }
  // Beyond the hand's turn on a twisted organ, the shaft would swing through the tissue.
  const bool undone = axis && controller_.scene()->comesTwisted();
  pointer_.setHeldAxis(axis, undone ? kHandTurn_rad + kLag_rad : PointerControls::kNoEnd_rad);
  const std::optional<SurfacePoint> near = controller_.nearby(state);
  const bool close = near && near->distance_m < kLeanWithin_m;
  pointer_.leanAwayFrom(close ? std::optional<Vec3>(near->normal) : std::nullopt);
  if (!holds && state.response.depth_m > kTooDeep_m) {
    pointer_.holdAt(state.tool.position_m);
  }
  if (!holds) {
    heldFrom_rad_ = state.response.angle_rad;
  }
  const bool goesRound = rides && (holds || state.phase == ExercisePhase::kReleased);
  const LiveState drawn = goesRound ? carried(state) : state;
  view_.setTool(drawn.tool, drawn.grip);
  return drawn;
}

LiveState ShownTool::carried(const LiveState& state) const {
  const Scene& scene = *controller_.scene();
  const AxisFrame frame = scene.graspFrame(state.response.graspArc_m, state.tool.position_m);
  // For a twisted organ, only the turn since gripping carries the tool round.
  const double turn_rad = state.response.angle_rad - (scene.comesTwisted() ? heldFrom_rad_ : 0.0);
  LiveState drawn = state;
  drawn.response.force_N = rotateAbout(state.response.force_N, frame.tangent, turn_rad);
  drawn.tool.position_m =
      scene.comesTwisted()
          ? frame.centre_m + rotateAbout(state.tool.position_m - frame.centre_m, frame.tangent, turn_rad)
          : scene.toDeformed_m(state.tool.position_m, organStateOf(state));
  return drawn;
}

}  // namespace torsio::gui
