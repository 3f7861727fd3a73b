// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/rating/assessment_run.h"

#include "db/connection/row_reader.h"
#include "sim/base/contracts.h"

namespace torsio {

std::string joinFlags(const std::vector<std::string>& flags) {
  std::string text;
  for (const std::string& flag : flags) {
    TORSIO_EXPECTS(!flag.empty() && flag.find(';') == std::string::npos);
    text += (text.empty() ? "" : ";") + flag;
  }
  return text;
}

std::vector<std::string> splitFlags(std::string_view text) {
  std::vector<std::string> flags;
  while (!text.empty()) {
    const std::size_t end = text.find(';');
    flags.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) {
      break;
    }
    text.remove_prefix(end + 1);
  }
  return flags;
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

std::optional<AssessmentRun> findLatestRun(Connection& connection, RunOwner owner,
                                           const std::string& ownerId) {
  const std::string column = owner == RunOwner::kCampaign ? "campaign_id" : "cohort_id";
  return selectFirst(
      connection,
      "SELECT id, formula_version, policy, inputs_hash, flags, software_version, computed_utc_us, "
      "demonstration"
      " FROM assessment_run WHERE " +
          column + " = ? ORDER BY computed_utc_us DESC, id DESC LIMIT 1",
      {ownerId}, [](RowReader& row) {
        return AssessmentRun{.id = row.text(),
                             .formulaVersion = row.text(),
                             .policy = row.text(),
                             .inputsHash = row.text(),
                             .flags = splitFlags(row.text()),
                             .softwareVersion = row.text(),
                             .computedUtc_us = row.int64(),
                             .demonstration = row.boolean()};
      });
}

}  // namespace torsio
