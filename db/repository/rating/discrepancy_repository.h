// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/mark.h"
#include "db/connection/connection.h"

namespace torsio {

/// Decisions about marks that differ strongly. Append-only; the newest counts. Each is recorded in the audit
/// trail
/// in the same transaction.
class DiscrepancyRepository {
 public:
  /// `station`: for the audit trail.
  explicit DiscrepancyRepository(Connection& connection, std::string station = {})
      : connection_(connection), station_(std::move(station)) {}

  /// Returns the sequence number. Throws DbError: kForeignKey (no such assignment).
  std::int64_t add(const DiscrepancyDecision& decision);
  /// Oldest first.
  [[nodiscard]] std::vector<DiscrepancyDecision> history(const AssignmentId& assignmentId) const;
  [[nodiscard]] std::optional<DiscrepancyDecision> latest(const AssignmentId& assignmentId) const;
  /// The newest decision of every assignment of a cohort, oldest first.
  [[nodiscard]] std::vector<DiscrepancyDecision> ofCohort(const CohortId& cohortId) const;

 private:
  Connection& connection_;
  std::string station_;
};

}  // namespace torsio
