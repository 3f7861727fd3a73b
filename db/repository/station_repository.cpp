// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/station_repository.h"

namespace torsio {

namespace {

const std::string kStations =
    "SELECT s.station, s.trial_id, s.user_id, s.software_version, s.heartbeat_utc_us, s.device_json,"
    " s.device_haptic, s.device_light, s.device_problem_json, s.device_checked_utc_us, p.code, t.scene_id,"
    " t.phase_label, t.started_utc_us, e.trial_id FROM station_state s LEFT JOIN trial t ON t.id = s.trial_id"
    " LEFT JOIN person p ON p.id = t.trainee_id LEFT JOIN trial_end e ON e.trial_id = s.trial_id";

std::vector<StationState> statesOf(Statement& row) {
  std::vector<StationState> states;
  while (row.step()) {
    states.push_back({.station = row.text(0),
                      .trialId = row.text(1),
                      .userId = row.text(2),
                      .softwareVersion = row.text(3),
                      .heartbeatUtc_us = row.int64(4),
                      .deviceJson = row.text(5),
                      .deviceHaptic = row.boolean(6),
                      .deviceLight = row.text(7),
                      .deviceProblemJson = row.text(8),
                      .deviceCheckedUtc_us = row.int64(9),
                      .traineeCode = row.text(10),
                      .sceneId = row.text(11),
                      .phaseLabel = row.text(12),
                      .startedUtc_us = row.int64(13),
                      .ended = !row.isNull(14)});
  }
  return states;
}

}  // namespace

void StationRepository::heartbeat(const StationState& state) {
  connection_.execute(
      "INSERT INTO station_state (station, trial_id, user_id, software_version, heartbeat_utc_us, "
      "device_json,"
      " device_haptic, device_light, device_problem_json, device_checked_utc_us)"
      " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT (station) DO UPDATE SET"
      " trial_id = excluded.trial_id, user_id = excluded.user_id,"
      " software_version = excluded.software_version, heartbeat_utc_us = excluded.heartbeat_utc_us,"
      " device_json = excluded.device_json, device_haptic = excluded.device_haptic,"
      " device_light = excluded.device_light, device_problem_json = excluded.device_problem_json,"
      " device_checked_utc_us = excluded.device_checked_utc_us",
      {state.station, textOrNull(state.trialId), textOrNull(state.userId), state.softwareVersion,
       state.heartbeatUtc_us, textOrNull(state.deviceJson), state.deviceHaptic, textOrNull(state.deviceLight),
       textOrNull(state.deviceProblemJson),
       state.deviceCheckedUtc_us == 0 ? Value() : Value(state.deviceCheckedUtc_us)});
}

void StationRepository::leave(const std::string& station) {
  connection_.execute("DELETE FROM station_state WHERE station = ?", {station});
}

std::optional<StationState> StationRepository::find(const std::string& station) {
  Statement row = connection_.prepare(kStations + " WHERE s.station = ?");
  row.execute({station});
  std::vector<StationState> found = statesOf(row);
  return found.empty() ? std::nullopt : std::optional(found.front());
}

std::vector<StationState> StationRepository::board() {
  Statement row = connection_.prepare(kStations + " ORDER BY s.station");
  row.execute();
  return statesOf(row);
}

std::optional<StationState> StationRepository::ownerOf(const std::string& trialId,
                                                       std::int64_t aliveSinceUtc_us) {
  Statement row =
      connection_.prepare(kStations +
                          " WHERE s.trial_id = ? AND s.heartbeat_utc_us >= ? AND e.trial_id IS NULL"
                          " ORDER BY s.heartbeat_utc_us DESC");
  row.execute({trialId, aliveSinceUtc_us});
  std::vector<StationState> found = statesOf(row);
  return found.empty() ? std::nullopt : std::optional(found.front());
}

}  // namespace torsio
