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

/// Plays the desktop's short alert sound.
void soundOfTheSystem();

/// Data shared by a trainee's pages at one station, and the hooks with which tests replace the real world.
/// Created with the pages at sign-in, passed to those that need it, and destroyed with them. GUI thread.
class StationDesk {
 public:
  /// Opens the device for a recording. Empty, or a null result: mouse and keyboard.
  using DeviceOpener = std::function<std::unique_ptr<HapticDevice>(const Scene&, double target_rad)>;

  SceneLoader loader = loadSceneForView;
  bool realTime = true;
  std::shared_ptr<const Clock> clock = std::make_shared<MonotonicClock>();
  Text device;                ///< the station's device; empty: mouse and keyboard
  bool rendersForce = false;  ///< for that device
  DeviceProbe probe;          ///< empty: mouse and keyboard
  DeviceOpener openDevice;
  std::optional<TrackerPlace> tracker;             ///< of the real arm; empty: none stored
  std::shared_ptr<InstrumentOutlet> outlet;        ///< output of the instrument to other programs; null: none
  std::function<void()> sound = soundOfTheSystem;  ///< played at a limit, if the centre wants it

  /// Scene of the last run, so that the debrief need not load it again.
  std::shared_ptr<const Scene> lastScene;

  SessionStory story;  ///< since the sign-in

  std::optional<DeviceReadiness> readiness;  ///< last device check since sign-in
  bool chosen = false;                       ///< something was chosen on the home page
  ModuleId moduleId;                         ///< chosen module; empty: the real arm
  bool graded = false;
  bool guided = false;  ///< movement by movement, regardless of experience

  /// Reports once to the board of the day that this station has an unchecked device. `line` may be null.
  void announce(StationWriter* line);

 private:
  bool announced_ = false;
};

/// Creates the desk of this machine, with its stored or detected device, if any.
[[nodiscard]] std::shared_ptr<StationDesk> deskOfThisStation();

}  // namespace torsio::gui
