// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/maintenance/others_at_work.h"

#include "db/repository/trial/station_repository.h"
#include "sim/base/error.h"

namespace torsio {

std::vector<Text> othersAtWork(SessionContext& workplace) {
  workplace.require(Operation::kDatabaseRestore);
  const std::int64_t aliveSince_us = workplace.now_us() - kStationSilence_us;
  std::vector<Text> sentences;
  for (const StationState& state : StationRepository(workplace.connection()).board()) {
    if (state.heartbeatUtc_us < aliveSince_us) {
      continue;
    }
    if (!state.trialId.empty() && !state.ended) {
      sentences.push_back(Text("a run is going on at the station %1", state.station));
    } else if (state.station != workplace.station()) {
      sentences.push_back(Text("the station %1 is connected", state.station));
    }
  }
  return sentences;
}

void requireNobodyAtWork(SessionContext& workplace) {
  const std::vector<Text> others = othersAtWork(workplace);
  if (others.empty()) {
    return;
  }
  throw Error(ErrorCode::kDatabase, others.front(), workplace.connection().location(),
              "Let the run come to its end, close Torsio at all other stations, wait half a minute, and try "
              "again");
}

}  // namespace torsio
