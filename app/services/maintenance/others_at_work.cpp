// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/maintenance/others_at_work.h"

#include "assessment/domain/study/station_state.h"
#include "db/repository/trial/station_repository.h"
#include "sim/core/error.h"

namespace torsio {

std::vector<Text> othersAtWork(SessionContext& session) {
  session.require(Operation::kDatabaseRestore);
  const std::int64_t aliveSince_us = session.now_us() - kStationSilence_us;
  std::vector<Text> sentences;
  for (const StationState& state : StationRepository(session.connection()).board()) {
    if (state.heartbeatUtc_us < aliveSince_us) {
      continue;
    }
    if (!state.trialId.empty() && !state.ended) {
      sentences.push_back(Text::tr("a run is in progress at the station %1", state.station));
    } else if (state.station != session.station()) {
      sentences.push_back(Text::tr("the station %1 is connected", state.station));
    }
  }
  return sentences;
}

void requireNobodyAtWork(SessionContext& session) {
  const std::vector<Text> others = othersAtWork(session);
  if (others.empty()) {
    return;
  }
  throw Error(
      ErrorCode::kDatabase, others.front(), session.connection().location(),
      Text::tr("Let the run finish, close Torsio at all other stations, wait half a minute, and try again"));
}

}  // namespace torsio
