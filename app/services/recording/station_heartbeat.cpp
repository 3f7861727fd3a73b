// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/recording/station_heartbeat.h"

#include "app/services/base/build_info.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/station_state.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/repository/trial/station_repository.h"
#include "db/repository/trial/trial_repository.h"

namespace torsio {

namespace {

// A trial that has just begun is in the database within a second, if that is reachable.
constexpr std::int64_t kAgain_us = 1'000'000;

}  // namespace

void StationHeartbeat::show(const TrialId& trialId) {
  changed_ = changed_ || trialId != trialId_;
  trialId_ = trialId;
}

void StationHeartbeat::showDevice(const StationDevice& device) {
  if (device == device_) {
    return;
  }
  changed_ = true;
  device_ = device;
}

void StationHeartbeat::send() {
  const std::int64_t now_us = session_->now_us();
  changed_ = changed_ || session_->actor().userId != shownUser_;
  if (!changed_ && now_us < next_us_) {
    return;
  }
  changed_ = false;
  shownUser_ = session_->actor().userId;
  next_us_ = now_us + kAgain_us;
  try {
    Connection& connection = session_->connectionWithoutRight();
    const bool there =
        trialId_.empty() || trialId_ == shownTrial_ || TrialRepository(connection).find(trialId_);
    const std::string trial = there ? trialId_ : "";
    StationState state{.station = session_->station(),
                       .trialId = trial,
                       .userId = session_->actor().userId,
                       .softwareVersion = softwareVersion(),
                       .heartbeatUtc_us = now_us};
    storeDevice(device_, state);
    StationRepository(connection).heartbeat(state);
    shownTrial_ = trial;
    if (there) {
      next_us_ = now_us + kHeartbeat_us;
    }
    answered_ = true;
  } catch (const DbError& error) {
    answered_ = error.fault() != DbFault::kUnreachable;
    shownTrial_.clear();
    next_us_ = now_us + kHeartbeat_us;  // each attempt may take seconds while the server is unreachable
  }
}

void StationHeartbeat::leave() {
  try {
    StationRepository(session_->connectionWithoutRight()).leave(session_->station());
  } catch (const DbError& error) {
    answered_ = error.fault() != DbFault::kUnreachable;
    shownTrial_.clear();
  }
  changed_ = true;
}

}  // namespace torsio
