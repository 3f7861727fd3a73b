// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/trainee/station_desk.h"

#include <cmath>
#include <utility>

#include <QApplication>

#include "app/connectors/tracker/tracker_choice.h"
#include "app/services/devices/haptic_station.h"
#include "app/services/recording/station_writer.h"

namespace torsio::gui {

void soundOfTheSystem() {
  QApplication::beep();
}

void StationDesk::announce(StationWriter* line) {
  if (line == nullptr || std::exchange(announced_, true)) {
    return;
  }
  line->showDevice(uncheckedDevice(device, rendersForce));
}

std::shared_ptr<StationDesk> deskOfThisStation() {
  auto desk = std::make_shared<StationDesk>();
  const DeviceChoice choice = stationChoice();
  if (deviceInstalled(choice)) {
    const DeviceDriver& driver = chosenDriver(choice);
    desk->device = Text(driver.name);
    desk->rendersForce = driver.rendersForce;
    desk->probe = hapticProbe(choice);
    desk->openDevice = [choice](const Scene& scene, double) { return openHapticDevice(scene, choice); };
  }
  desk->tracker = rememberedTracker().tracker;
  desk->outlet = outletOfThisStation();
  return desk;
}

void SessionStory::begin(std::int64_t now_us) {
  begunUtc_us_ = begunUtc_us_.value_or(now_us);
}

bool SessionStory::add(const Debrief& debrief) {
  const bool ofThisSession = begunUtc_us_ && debrief.startedUtc_us >= *begunUtc_us_;
  if (!ofThisSession || debrief.verdict.outcome == RunOutcome::kInterrupted ||
      !seen_.insert(debrief.trialId).second) {
    return false;
  }
  bool better = false;
  for (const TwistResult& twist : debrief.twists) {
    ++twists_;
    if (!twist.passed) {
      continue;
    }
    ++onTarget_;
    const double error_rad = std::abs(twist.released_rad - twist.target_rad);
    if (!best_ || error_rad < best_->error_rad) {
      best_ = BestTwist{debrief.trialId, debrief.moduleTitle, twist, error_rad, {}};
      better = true;
    }
  }
  return better;
}

void SessionStory::setPicture(QImage picture) {
  if (best_) {
    best_->picture = std::move(picture);
  }
}

}  // namespace torsio::gui
