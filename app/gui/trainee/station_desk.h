// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include <QImage>
#include <QObject>

#include "app/connectors/tracker/instrument_outlet.h"
#include "app/connectors/tracker/tracker_link.h"
#include "app/gui/simulator/simulation_controller.h"
#include "app/services/devices/device_readiness.h"
#include "app/services/training/debrief.h"
#include "assessment/domain/ids.h"
#include "sim/core/clock.h"
#include "sim/device/haptic_device.h"

namespace torsio {
class StationWriter;
}

namespace torsio::gui {

/// The twist of a session released nearest to its target.
struct BestTwist {
  TrialId trialId{};
  std::string moduleTitle{};
  TwistResult twist{};
  double error_rad = 0.0;  ///< absolute
  QImage picture{};        ///< of the organ before its release; null: not taken, or nothing can be drawn
};

/// A trainee's work since sign-in, from the debriefs. Use from one thread.
class SessionStory {
 public:
  /// Excludes runs that started earlier. Only the first call counts.
  void begin(std::int64_t now_us);
  /// Adds a run, once. True: it contains the session's best twist.
  bool add(const Debrief& debrief);
  /// Sets the best twist's picture; no effect without one.
  void setPicture(QImage picture);

  [[nodiscard]] std::size_t runs() const noexcept { return seen_.size(); }
  [[nodiscard]] std::size_t twists() const noexcept { return twists_; }  ///< completed
  [[nodiscard]] std::size_t onTarget() const noexcept { return onTarget_; }
  /// Empty until a twist has been released on target.
  [[nodiscard]] const std::optional<BestTwist>& best() const noexcept { return best_; }

 private:
  std::optional<std::int64_t> begunUtc_us_;
  std::set<TrialId> seen_;
  std::size_t twists_ = 0;
  std::size_t onTarget_ = 0;
  std::optional<BestTwist> best_;
};

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
