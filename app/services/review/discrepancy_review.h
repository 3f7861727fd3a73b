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
#include "sim/core/text.h"

namespace torsio {

/// One row of a submitted sheet with the mean of the others, in points, anonymous.
struct RowComparison {
  std::string row{};    ///< code; kOverallRow: the overall mark
  std::string label{};  ///< empty for the overall mark
  double own = 0.0;
  double mean = 0.0;  ///< of the other raters
  double lowest = 0.0;
  double highest = 0.0;
  std::size_t others = 0;
  bool apart = false;  ///< differs from the mean by at least the threshold
  ScoreScale scale{};
};

/// A case submitted by all raters in which the actor's marks differ.
struct DiscrepancyCase {
  BlindedCase shown{};
  std::vector<RowComparison> rows{};            ///< in rubric order, the overall mark last
  double largest = 0.0;                         ///< largest difference, points
  std::optional<DiscrepancyChoice> decision{};  ///< empty: pending
  std::string reason{};
};

/// Returns only discrepancies, in the rater's own order; a case with a changed mark stays listed with its
/// decision while it still differs. kMarkSubmit. Ignores cases whose panel is not open to the actor
/// (panel_opening.h).
[[nodiscard]] std::vector<DiscrepancyCase> discrepancyCases(SessionContext& session);
/// Returns the number of cases that all have submitted, but whose panel waits for the actor's own sheets of
/// the occasion. kMarkSubmit.
[[nodiscard]] std::size_t casesSealedForNow(SessionContext& session);

/// Returns when cases are compared, by the centre's setting (kPanelWaits), and how many wait for the actor's
/// own sheets: what an empty list says. kMarkSubmit.
[[nodiscard]] Text whenCasesAreCompared(SessionContext& session);

/// Keeps the mark. kMarkSubmit, the actor's case, submitted by all; audited.
void keepMark(SessionContext& session, const AssignmentId& assignmentId, const std::string& reason);
/// Adds a version to the actor's sheet; both are kept. Throws Error{kBadParameter} without a reason,
/// {kBadData} unless the panel is open. kMarkSubmit, the actor's case; audited.
void moveMark(SessionContext& session, const AssignmentId& assignmentId, const Sheet& sheet,
              const std::string& reason);
/// Changes the actor's submitted sheet with amendSheet() while the panel's marks are hidden, with moveMark()
/// afterwards. kMarkSubmit, the actor's case; audited. Throws like them.
void changeSubmitted(SessionContext& session, const AssignmentId& assignmentId, const Sheet& sheet,
                     const std::string& reason);
/// Requests another rater from the administrator; needs a reason. kMarkSubmit, the actor's case, submitted by
/// all; audited.
void askForAdjudicator(SessionContext& session, const AssignmentId& assignmentId, const std::string& reason);

/// One submitted case: the actor's overall mark and the mean of the others, points.
struct SeverityCase {
  std::string label{};
  double own = 0.0;
  double panel = 0.0;
};

/// The actor's severity relative to the other raters on the same cases. Never shown for anybody else: there
/// is no table of raters.
struct OwnSeverity {
  std::vector<SeverityCase> cases{};          ///< in the actor's order
  std::optional<double> difference_points{};  ///< mean of own minus panel mark; negative: stricter
  std::optional<Interval> interval_points{};  ///< 95 % interval of the mean difference; empty: fewer than two
                                              ///< cases
  std::optional<double> ownMean_points{};
  std::optional<double> panelMean_points{};
  std::size_t waiting = 0;     ///< submitted cases that others have not submitted
  std::size_t sealed = 0;      ///< cases whose panel waits for the actor's own sheets of the occasion
  double lowest_points = 0.0;  ///< lowest mark of the scale
  double highest_points = 10.0;
  std::vector<std::size_t> used{};  ///< frequency of each whole point from lowest to highest
};

/// Based on overall marks of cases that all raters have submitted, except "not assessable". The mean of the
/// others excludes the actor. kMarkSubmit.
[[nodiscard]] OwnSeverity ownSeverity(SessionContext& session);

}  // namespace torsio
