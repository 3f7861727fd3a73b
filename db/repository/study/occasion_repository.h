// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/occasion.h"
#include "db/connection/connection.h"

namespace torsio {

/// The occasions that the record knows, and which of them a cohort uses. One call, one transaction.
class OccasionRepository {
 public:
  explicit OccasionRepository(Connection& connection) : connection_(connection) {}

  /// Lists all occasions in order of time, without times of exposure: those belong to curricula.
  [[nodiscard]] Occasions all() const;
  /// Adds an occasion after all others. Throws DbError{kUnique} when the code is taken.
  void add(const Occasion& occasion);
  /// Gives the codes at which somebody of a cohort was marked or a rater is asked for marks.
  [[nodiscard]] std::set<std::string> usedBy(const CohortId& cohortId) const;
  /// Tells whether a cohort was imported with recordings of other equipment (sim/core/foreign_recording.h);
  /// those of a tracker belong to a phase of its own curriculum.
  [[nodiscard]] bool cameFromElsewhere(const CohortId& cohortId) const;

 private:
  Connection& connection_;
};

}  // namespace torsio
