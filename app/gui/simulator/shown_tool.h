// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/simulator/pointer_controls.h"
#include "app/gui/simulator/simulation_controller.h"
#include "sim/core/live_types.h"

namespace torsio::gui {

class SceneView;

/// Draws the instrument where it holds the tissue, and tells the pointer what it holds and what it is near
/// to. A hand that twists by turning stays in place; what is drawn goes round with the tissue that it holds.
/// GUI thread; the three outlive it.
class ShownTool {
 public:
  ShownTool(SimulationController& controller, PointerControls& pointer, SceneView& view)
      : controller_(controller), pointer_(pointer), view_(view) {}

  /// Shows one state and returns it as it is drawn, with tool and force where the tissue has carried them.
  /// Called once a frame, in the order of time.
  LiveState show(const LiveState& state);

 private:
  [[nodiscard]] LiveState carried(const LiveState& state) const;

  SimulationController& controller_;
  PointerControls& pointer_;
  SceneView& view_;
  double heldFrom_rad_ = 0.0;  // how far the organ was turned when the jaw took hold of it
};

}  // namespace torsio::gui
