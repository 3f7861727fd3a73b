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

/// One step in tracing a reported number to its sources.
struct TraceStep {
  Text what{};          ///< "score of T-07, after 40 min"
  std::string value{};  ///< as in the table; empty: none
  std::vector<TraceStep> madeOf{};
};

/// The number to trace: a row of the cohort's table of numbers, from its first cell to its statistic, exactly
/// as in the table ("training,T-07,Group 1,,,after 40 min,score").
struct TraceRequest {
  std::string record{};    ///< file or address of the record; opened read-only
  std::string cohort{};    ///< name; empty: the oldest
  std::string campaign{};  ///< name of the evaluation of models; empty: the oldest with marks
  std::string cell{};
};

class Connection;

/// Reads all data of a cohort and an evaluation, under codes, for the command line.
[[nodiscard]] CohortInputs wholeInputs(Connection& connection, const CohortId& cohortId,
                                       const CampaignId& campaignId);

/// Traces the numbers of one cohort, as far as its reader may look: if single marks are hidden, it ends at
/// their count.
class CellTracer {
 public:
  CellTracer(Connection& connection, const CohortId& cohortId, const CohortInputs& inputs);
  CellTracer(const CellTracer&) = delete;
  CellTracer& operator=(const CellTracer&) = delete;
  ~CellTracer();

  /// Throws Error{kBadParameter} if the ledger has no such result.
  [[nodiscard]] TraceStep trace(const std::string& cell);

 private:
  class Walk;
  std::unique_ptr<Walk> walk_;
};

/// Traces a number to its marks, criteria, scoring sheet revision, recording and program. Throws
/// Error{kBadParameter} for an unknown cohort, campaign or cell; DbError.
[[nodiscard]] TraceStep traceCell(const TraceRequest& request);

/// Traces a number of a report made from `inputs`. kResultsCompute. Throws Error{kBadParameter} if the table
/// of numbers has no such row.
[[nodiscard]] TraceStep traceNumber(SessionContext& session, const CohortId& cohortId,
                                    const CohortInputs& inputs, const std::string& cell);

}  // namespace torsio
