// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/trial/station_repository.h"

#include "db/connection/row_reader.h"
#include "db/repository/trial/servo_health_columns.h"

namespace torsio {

namespace {

const std::string kStations =
    "SELECT s.station, s.trial_id, s.user_id, s.software_version, s.heartbeat_utc_us, s.device_json,"
    " s.device_haptic, s.device_light, s.device_problem_json, s.device_checked_utc_us, p.code, t.scene_id,"
    " t.phase_label, t.started_utc_us, e.trial_id, " +
    servoHealthColumns("h") +
    ", h.sample_count, h.ended_utc_us FROM station_state s LEFT JOIN trial t ON t.id = s.trial_id"
    " LEFT JOIN person p ON p.id = t.trainee_id LEFT JOIN trial_end e ON e.trial_id = s.trial_id"
    " LEFT JOIN trial_end h ON h.trial_id = (SELECT x.trial_id FROM trial y JOIN trial_end x ON"
    " x.trial_id = y.id WHERE y.station = s.station AND x.skipped_ticks IS NOT NULL"
    " ORDER BY y.started_utc_us DESC LIMIT 1)";

StationState stateOf(RowReader& row) {
  return {.station = row.text(),
          .trialId = row.text(),
          .userId = row.text(),
          .softwareVersion = row.text(),
          .heartbeatUtc_us = row.int64(),
          .deviceJson = row.text(),
          .deviceHaptic = row.boolean(),
          .deviceLight = row.text(),
          .deviceProblemJson = row.text(),
          .deviceCheckedUtc_us = row.int64(),
          .traineeCode = row.text(),
          .sceneId = row.text(),
          .phaseLabel = row.text(),
          .startedUtc_us = row.int64(),
          .ended = row.hasValue(),
          .lastHealth = servoHealthOf(row),
          .lastTicks = row.int64(),
          .lastEndedUtc_us = row.int64()};
}

}  // namespace

void StationRepository::heartbeat(const StationState& state) {
  connection_.execute(
      insertInto("station_state",
                 "station, trial_id, user_id, software_version, heartbeat_utc_us, device_json,"
                 " device_haptic, device_light, device_problem_json, device_checked_utc_us") +
          " ON CONFLICT (station) DO UPDATE SET trial_id = excluded.trial_id, user_id ="
          " excluded.user_id, software_version = excluded.software_version, heartbeat_utc_us"
          " = excluded.heartbeat_utc_us, device_json = excluded.device_json, device_haptic ="
          " excluded.device_haptic, device_light = excluded.device_light,"
          " device_problem_json = excluded.device_problem_json, device_checked_utc_us ="
          " excluded.device_checked_utc_us",
      {state.station, textOrNull(state.trialId), textOrNull(state.userId), state.softwareVersion,
       state.heartbeatUtc_us, textOrNull(state.deviceJson), state.deviceHaptic, textOrNull(state.deviceLight),
       textOrNull(state.deviceProblemJson),
       state.deviceCheckedUtc_us == 0 ? Value() : Value(state.deviceCheckedUtc_us)});
}

std::optional<std::int64_t> StationRepository::lastHeartbeatUtc_us(const std::string& station) const {
  return selectFirst(connection_, "SELECT heartbeat_utc_us FROM station_state WHERE station = ?", {station},
                     [](RowReader& row) { return row.int64(); });
}

void StationRepository::leave(const std::string& station) {
  connection_.execute("DELETE FROM station_state WHERE station = ?", {station});
}

std::vector<StationState> StationRepository::board() const {
  return selectAll(connection_, kStations + " ORDER BY s.station", {}, stateOf);
}

}  // namespace torsio
