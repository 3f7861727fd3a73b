// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/statistics/values.h"

namespace torsio {

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
