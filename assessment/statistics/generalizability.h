// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assessment/statistics/values.h"

namespace torsio {

/// One effect of a generalizability study.
struct GComponent {
  std::string effect;  ///< "p", "r", "pr,e" ...
  double sumOfSquares = 0.0;
  double df = 0.0;
  double meanSquare = 0.0;
  double variance = 0.0;  ///< from expected mean squares; may be negative, reported as is
};

struct GStudy {
  std::vector<GComponent> components;
  bool negativeComponent = false;
  double personsPerRater = 0.0;  ///< of persons x raters; otherwise 0
  /// Returns the component named `effect`; throws ContractError if there is none.
  [[nodiscard]] const GComponent& at(const std::string& effect) const;
};

/// Projection to other numbers of conditions. Negative components count as 0 here, and only here.
struct DStudy {
  double relativeError = 0.0;
  double absoluteError = 0.0;
  double generalizability = 0.0;  ///< E rho^2, of the order of persons
  double dependability = 0.0;     ///< Phi, of the level of persons
};

/// Analyses persons x raters, complete. Effects "p", "r", "pr", all random. Undefined with fewer than two of
/// either.
[[nodiscard]] Outcome<GStudy> gStudyPR(const NumberTable& ratings);
/// As gStudyPR(), within groups of persons who were all rated by the same raters: differences between groups
/// count neither as differences between persons nor as errors; a rater is equally severe in all of them.
/// Groups of one person are left out.
[[nodiscard]] Outcome<GStudy> gStudyPRWithin(const std::vector<NumberTable>& groups);
[[nodiscard]] Outcome<DStudy> dStudyPR(const GStudy& study, double raters);
/// Returns the interval of the dependability of the mean of `raters` raters; empty like agreementInterval().
[[nodiscard]] std::optional<Interval> dependabilityInterval(const GStudy& study, double raters,
                                                            double confidence = kDefaultConfidence);

/// Analyses persons x raters x occasions, complete; byOccasion[o] is persons x raters. Effects "p", "r", "o",
/// "pr", "po", "ro", "pro". Occasions must be replicates: a change by training is not a random occasion.
[[nodiscard]] Outcome<GStudy> gStudyPRO(const std::vector<NumberTable>& byOccasion);
[[nodiscard]] Outcome<DStudy> dStudyPRO(const GStudy& study, double raters, double occasions);

/// Analyses raters nested in tasks, persons crossed with both; byTask[t] is persons x raters of that task.
/// Effects "p", "t", "r:t", "pt", "pr:t".
[[nodiscard]] Outcome<GStudy> gStudyPRinT(const std::vector<NumberTable>& byTask);
[[nodiscard]] Outcome<DStudy> dStudyPRinT(const GStudy& study, double tasks, double ratersPerTask);

}  // namespace torsio
