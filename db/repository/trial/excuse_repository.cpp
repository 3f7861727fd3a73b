// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/trial/excuse_repository.h"

#include "db/repository/base/row_columns.h"

namespace torsio {

namespace {

constexpr auto kExcuse =
    rowColumns<RunExcuse>("run_excuse", "trial_id, excused_by, excused_utc_us, reason", &RunExcuse::trialId,
                          &RunExcuse::excusedBy, &RunExcuse::excusedUtc_us, &RunExcuse::reason);

}  // namespace

void ExcuseRepository::add(const RunExcuse& excuse) {
  connection_.prepare(kExcuse.insert()).execute(kExcuse.values(excuse));
}

std::optional<RunExcuse> ExcuseRepository::of(const TrialId& trialId) const {
  return selectFirst(connection_, kExcuse.select("e") + " FROM run_excuse e WHERE e.trial_id = ?", {trialId},
                     kExcuse);
}

}  // namespace torsio
