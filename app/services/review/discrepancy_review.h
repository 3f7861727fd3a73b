// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/review/blinded_case.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/instrument.h"
#include "assessment/domain/rating/sheet.h"
#include "assessment/statistics/values.h"

namespace torsio {

/// One row of a committed sheet beside what the others gave. In points; nobody is named.
struct RowComparison {
  std::string row{};    ///< code; kOverallRow: the overall mark
  std::string label{};  ///< empty for the overall mark
  double own = 0.0;
  double mean = 0.0;  ///< of the others
  double lowest = 0.0;
  double highest = 0.0;
  std::size_t others = 0;
  bool apart = false;  ///< own and mean differ by at least the threshold
  ScoreScale scale{};
};

/// A case on which all have committed and where the own sheet lies apart.
struct DiscrepancyCase {
  BlindedCase shown{};
  std::vector<RowComparison> rows{};            ///< in the rubric's order, the overall mark last
  double largest = 0.0;                         ///< distance, points
  std::optional<DiscrepancyChoice> decision{};  ///< empty: to be decided
  std::string reason{};
};

/// Disagreements only, in the rater's own order; a case that was moved stays listed with its decision as long
/// as it lies apart. kMarkSubmit. Cases on which somebody has not committed are not even looked at.
[[nodiscard]] std::vector<DiscrepancyCase> discrepancyCases(SessionContext& session);

/// The mark stays. kMarkSubmit, own committed case; audited.
void keepMark(SessionContext& session, const AssignmentId& assignmentId, const std::string& reason);
/// A new version of the own sheet; both stay. Throws Error{kBadParameter} without a reason, {kBadData} when
/// not all have committed. kMarkSubmit, own committed case; audited.
void moveMark(SessionContext& session, const AssignmentId& assignmentId, const Sheet& sheet,
              const std::string& reason);
/// The next version of an own submitted sheet, by the rules of what its author may know by now: amendSheet()
/// before the marks of the panel are open, moveMark() after. kMarkSubmit, own case; audited. Throws as they
/// do.
void changeSubmitted(SessionContext& session, const AssignmentId& assignmentId, const Sheet& sheet,
                     const std::string& reason);
/// The administrator is asked for a further rater; needs a reason. kMarkSubmit, own committed case; audited.
void askForAdjudicator(SessionContext& session, const AssignmentId& assignmentId, const std::string& reason);

/// One committed case: own overall mark and the mean of the others, points.
struct SeverityCase {
  std::string label{};
  double own = 0.0;
  double panel = 0.0;
};

/// How strict the actor is, compared with the others on the same cases. Nobody else is shown: no table of
/// raters exists.
struct OwnSeverity {
  std::vector<SeverityCase> cases{};          ///< in own order
  std::optional<double> difference_points{};  ///< mean of own minus panel; negative: stricter
  std::optional<Interval> interval_points{};  ///< 95 % of the mean difference; empty: fewer than two cases
  std::optional<double> ownMean_points{};
  std::optional<double> panelMean_points{};
  std::size_t waiting = 0;     ///< own submitted cases on which others have not committed
  double lowest_points = 0.0;  ///< of the scale
  double highest_points = 10.0;
  std::vector<std::size_t> used{};  ///< how often each whole point from lowest to highest was given
};

/// Overall marks of cases on which all have committed; "not assessable" ones are left out. The mean of the
/// others does not contain the own mark. kMarkSubmit.
[[nodiscard]] OwnSeverity ownSeverity(SessionContext& session);

}  // namespace torsio
