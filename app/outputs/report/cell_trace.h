// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "assessment/results/cohort_report.h"
#include "sim/core/text.h"

namespace torsio {

/// One step from a number of a report back to what it was made of.
struct TraceStep {
  Text what{};          ///< "score of T-07, after 40 min"
  std::string value{};  ///< as it stands in the table; empty: none
  std::vector<TraceStep> madeOf{};
};

/// Which number: a line of the cohort's table of numbers, from its first cell to its statistic, as it stands
/// there ("training,T-07,Group 1,,,after 40 min,score").
struct TraceRequest {
  std::string record{};    ///< file or address of the record; opened for reading
  std::string cohort{};    ///< name; empty: the oldest one
  std::string campaign{};  ///< name of the evaluation of models; empty: the oldest one that has marks
  std::string cell{};
};

class Connection;

/// Returns what the command line follows: everything that is known of a cohort and an evaluation of models,
/// under codes.
[[nodiscard]] CohortInputs wholeInputs(Connection& connection, const CohortId& cohortId,
                                       const CampaignId& campaignId);

/// Follows the numbers of one cohort, as far as its reader may look: where single marks are not shown, it
/// ends at how many there are.
class CellTracer {
 public:
  CellTracer(Connection& connection, const CohortId& cohortId, const CohortInputs& inputs);
  CellTracer(const CellTracer&) = delete;
  CellTracer& operator=(const CellTracer&) = delete;
  ~CellTracer();

  /// Throws Error{kBadParameter}: the ledger has no such result.
  [[nodiscard]] TraceStep trace(const std::string& cell);

 private:
  class Walk;
  std::unique_ptr<Walk> walk_;
};

/// Follows a number to its marks, criteria, revision of the scoring sheet, recording and program. Throws
/// Error{kBadParameter}: no such cohort, campaign or cell; DbError.
[[nodiscard]] TraceStep traceCell(const TraceRequest& request);

/// Follows a number of a report that was made of `inputs`. kResultsCompute. Throws Error{kBadParameter}: the
/// table of numbers has no such line.
[[nodiscard]] TraceStep traceNumber(SessionContext& session, const CohortId& cohortId,
                                    const CohortInputs& inputs, const std::string& cell);

}  // namespace torsio
