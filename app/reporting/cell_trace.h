// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "sim/base/ids.h"

namespace torsio {

/// One step from a number of a report back to what it was made of.
struct TraceStep {
  std::string what{};   ///< "score of T-07 after 40 min: mean of the raters' marks"
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

/// Follows a number to its marks, criteria, revision of the scoring sheet, recording and program. Throws
/// Error{kBadParameter}: no such cohort, campaign or cell; DbError.
[[nodiscard]] TraceStep traceCell(const TraceRequest& request);

}  // namespace torsio
