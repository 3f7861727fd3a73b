// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "assessment/results/cohort_report.h"

namespace torsio::testing {

// What a cohort's report says, word by word, for tests that hold it to the truth.

/// The same inputs with scores and summaries of the marks that they have now.
[[nodiscard]] CohortInputs scored(CohortInputs in);
/// The demonstration's cohort without the marks that `lost` says.
[[nodiscard]] CohortInputs losing(const std::function<bool(const TrainingMark&)>& lost);
/// The demonstration's cohort with each mark changed.
[[nodiscard]] CohortInputs marking(const std::function<void(TrainingMark&)>& change);

/// The demonstration's cohort with three untwistings of the first group in one phase: two undone, one of them
/// after a relapse; in the third blood never came back.
[[nodiscard]] CohortInputs withUntwistings();

/// The demonstration's cohort, of whose models the class of raters that counts most has given no mark.
[[nodiscard]] CohortInputs aClassOfRatersIsMissing();

/// Null: there is none.
[[nodiscard]] const ReportFigure* figureNamed(const ReportModel& report, const std::string& id);
[[nodiscard]] const ReportTable* tableNamed(const ReportModel& report, const std::string& id);
/// All paragraphs, a line each.
[[nodiscard]] std::string paragraphsOf(const ReportModel& report);
/// How many rows of the table of numbers hold the statistic.
[[nodiscard]] std::int64_t csvCount(const CohortInputs& in, const std::string& statistic);

/// A sentence or cell of a report, with what heads it.
struct Said {
  std::string head;  ///< title of the column, where the text is a cell
  std::string text;
};
[[nodiscard]] std::vector<Said> everythingSaid(const ReportModel& report);
/// All of it, a line each.
[[nodiscard]] std::string textOfAll(const CohortInputs& in);

/// Fails where a report or its table of numbers holds no number for one, p = 0, an interval without its
/// level, a text with a hole, or a value that is neither there nor said to be undefined.
void expectWellSaid(const CohortInputs& in);

}  // namespace torsio::testing
