// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/rating/assessment_run.h"

#include "db/connection/row_reader.h"
#include "sim/core/contracts.h"

namespace torsio {

std::string joinFlags(const std::vector<std::string>& flags) {
  std::string text;
  for (const std::string& flag : flags) {
    TORSIO_EXPECTS(!flag.empty() && flag.find(';') == std::string::npos);
    text += (text.empty() ? "" : ";") + flag;
  }
  return text;
}

void insertRun(Connection& connection, RunOwner owner, const std::string& ownerId, const AssessmentRun& run) {
  const bool campaign = owner == RunOwner::kCampaign;
  connection.execute(insertInto("assessment_run",
                                "id, campaign_id, cohort_id, formula_version, policy, inputs_hash, flags,"
                                " software_version, computed_utc_us, demonstration"),
                     {run.id, campaign ? Value(ownerId) : Value(), campaign ? Value() : Value(ownerId),
                      run.formulaVersion, run.policy, run.inputsHash, joinFlags(run.flags),
                      run.softwareVersion, run.computedUtc_us, run.demonstration});
}

}  // namespace torsio
