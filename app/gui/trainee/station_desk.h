// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <QObject>

#include "app/devices/device_readiness.h"
#include "app/gui/simulator/simulation_controller.h"
#include "sim/base/clock.h"
#include "sim/device/haptic_device.h"

namespace torsio::gui {

class ShellContext;

/// What the pages of one trainee at one station hand to each other, and what a test puts in place of the
/// real world. Lives as long as the shell context.
class StationDesk : public QObject {
  Q_OBJECT

 public:
  /// The one of this shell; made at the first call, with the haptic device where its library is installed.
  [[nodiscard]] static StationDesk& of(ShellContext& shell);

  /// Opens the device for one recording. Empty, or an answer of null: mouse and keyboard.
  using DeviceOpener = std::function<std::unique_ptr<HapticDevice>(const Scene&, double target_rad)>;

  SceneLoader loader = loadSceneForView;
  bool realTime = true;
  std::shared_ptr<const Clock> clock = std::make_shared<MonotonicClock>();
  DeviceProbe probe;  ///< empty: mouse and keyboard
  DeviceOpener openDevice;

  /// Of the run that has just ended: the debrief need not load it again.
  std::shared_ptr<const Scene> lastScene;

  std::optional<DeviceReadiness> readiness;  ///< of the last device check since the sign-in
  bool chosen = false;                       ///< something was chosen on the first page
  std::string moduleId;                      ///< what; empty: the real arm
  bool graded = false;

 private:
  using QObject::QObject;
};

}  // namespace torsio::gui
