// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/sheet.h"
#include "assessment/domain/rating/sheet_check.h"

namespace torsio {

/// A paper sheet as typed in by one person.
struct PaperEntry {
  AssignmentId assignmentId{};
  UserId enteredBy{};
  Sheet sheet{};
  std::int64_t enteredUtc_us = 0;
};

/// Returns the codes of the rows (kOverallRow: the overall mark) in which two typed copies differ. Free text
/// (reasons, comments) is not compared.
[[nodiscard]] std::vector<std::string> differencesOf(const RubricRevision& rubric, const Sheet& first,
                                                     const Sheet& second);
/// Returns the codes of the rows with invalid answers: unanswered, contradictory, off the scale.
[[nodiscard]] std::vector<std::string> faultyRows(const RubricRevision& rubric, const Sheet& sheet);

}  // namespace torsio
