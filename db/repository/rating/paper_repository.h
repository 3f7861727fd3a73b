// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/paper_entry.h"
#include "db/connection/connection.h"

namespace torsio {

/// Sheets on paper while they are typed in. One call, one transaction.
class PaperRepository {
 public:
  explicit PaperRepository(Connection& connection) : connection_(connection) {}

  /// Takes the place of what the same person typed before.
  void put(const PaperEntry& entry);
  /// Of one sheet, oldest first.
  [[nodiscard]] std::vector<PaperEntry> of(const AssignmentId& assignmentId) const;
  /// Of a cohort, without rows.
  [[nodiscard]] std::vector<PaperEntry> ofCohort(const CohortId& cohortId) const;
  void remove(const AssignmentId& assignmentId);

 private:
  Connection& connection_;
};

}  // namespace torsio
