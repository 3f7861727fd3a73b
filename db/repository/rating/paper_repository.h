// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/paper_entry.h"
#include "db/connection/connection.h"

namespace torsio {

/// Paper sheets being typed in. Each call is one transaction.
class PaperRepository {
 public:
  explicit PaperRepository(Connection& connection) : connection_(connection) {}

  /// Replaces what the same person typed before.
  void put(const PaperEntry& entry);
  /// Entries of one sheet, oldest first.
  [[nodiscard]] std::vector<PaperEntry> of(const AssignmentId& assignmentId) const;
  /// Entries of a cohort, without rows.
  [[nodiscard]] std::vector<PaperEntry> ofCohort(const CohortId& cohortId) const;
  void remove(const AssignmentId& assignmentId);

 private:
  Connection& connection_;
};

}  // namespace torsio
