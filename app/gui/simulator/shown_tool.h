// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/simulator/pointer_controls.h"
#include "app/gui/simulator/simulation_controller.h"
#include "sim/core/live_types.h"

namespace torsio::gui {

class SceneView;

/// Draws the instrument where it holds the tissue, and tells the pointer what it holds and what is near. A
/// hand that twists by turning stays in place; the drawn tool moves with the tissue. GUI thread; view,
/// pointer and controller must outlive it.
class ShownTool {
 public:
  ShownTool(SimulationController& controller, PointerControls& pointer, SceneView& view)
      : controller_(controller), pointer_(pointer), view_(view) {}

  /// Shows a state and returns it as drawn, with tool and force moved by the tissue. Call once per frame, in
  /// chronological order.
  LiveState show(const LiveState& state);

 private:
  [[nodiscard]] LiveState carried(const LiveState& state) const;

  SimulationController& controller_;
  PointerControls& pointer_;
  SceneView& view_;
  double heldFrom_rad_ = 0.0;  // turn of the organ when it was gripped
};

}  // namespace torsio::gui
