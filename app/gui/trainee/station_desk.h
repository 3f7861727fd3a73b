// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <QObject>

#include "app/connectors/tracker/instrument_outlet.h"
#include "app/connectors/tracker/tracker_link.h"
#include "app/gui/simulator/simulation_controller.h"
#include "app/gui/trainee/session_story.h"
#include "app/services/devices/device_readiness.h"
#include "assessment/domain/ids.h"
#include "sim/core/clock.h"
#include "sim/device/haptic_device.h"

namespace torsio {
class StationWriter;
}

namespace torsio::gui {

/// The short sound that the desktop gives for "look here".
void soundOfTheSystem();

/// What the pages of one trainee at one station hand to each other, and what a test puts in place of the
/// real world. Made with the pages of a sign-in, handed to those that need it, and gone with them. GUI
/// thread.
class StationDesk {
 public:
  /// Opens the device for one recording. Empty, or an answer of null: mouse and keyboard.
  using DeviceOpener = std::function<std::unique_ptr<HapticDevice>(const Scene&, double target_rad)>;

  SceneLoader loader = loadSceneForView;
  bool realTime = true;
  std::shared_ptr<const Clock> clock = std::make_shared<MonotonicClock>();
  Text device;                ///< the station's device; empty: mouse and keyboard
  bool rendersForce = false;  ///< that device does
  DeviceProbe probe;          ///< empty: mouse and keyboard
  DeviceOpener openDevice;
  std::optional<TrackerPlace> tracker;             ///< of the real arm; empty: none is remembered
  std::shared_ptr<InstrumentOutlet> outlet;        ///< where others watch the instrument; null: nowhere
  std::function<void()> sound = soundOfTheSystem;  ///< when a limit is reached, where the centre wants it

  /// Of the run that has just ended: the debrief need not load it again.
  std::shared_ptr<const Scene> lastScene;

  SessionStory story;  ///< since the sign-in

  std::optional<DeviceReadiness> readiness;  ///< of the last device check since the sign-in
  bool chosen = false;                       ///< something was chosen on the first page
  ModuleId moduleId;                         ///< what; empty: the real arm
  bool graded = false;
  bool guided = false;  ///< movement by movement, whatever was done before

  /// Tells the board of the day, once, that a device stands here which nobody has checked yet. `line` may be
  /// null.
  void announce(StationWriter* line);

 private:
  bool announced_ = false;
};

/// Makes the desk of this machine: with the device that it remembers or has, where there is one.
[[nodiscard]] std::shared_ptr<StationDesk> deskOfThisStation();

}  // namespace torsio::gui
