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

/// A sheet on paper as one person typed it.
struct PaperEntry {
  AssignmentId assignmentId{};
  UserId enteredBy{};
  Sheet sheet{};
  std::int64_t enteredUtc_us = 0;
};

/// Codes of the rows (kOverallRow: the overall mark) at which two typed sheets say different things. Words
/// are not compared: a reason or a comment is typed by hand.
[[nodiscard]] std::vector<std::string> differencesOf(const RubricRevision& rubric, const Sheet& first,
                                                     const Sheet& second);
/// Codes of the rows that no sheet may leave like this: unanswered, contradicting, outside the scale.
[[nodiscard]] std::vector<std::string> faultyRows(const RubricRevision& rubric, const Sheet& sheet);

}  // namespace torsio
