// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "assessment/attempt/trial_digest.h"
#include "assessment/domain/ids.h"
#include "db/connection/connection.h"

namespace torsio {

/// Digests of recordings. Append-only: another version of the formulas or other rules add a row.
class DigestRepository {
 public:
  explicit DigestRepository(Connection& connection) : connection_(connection) {}

  /// Stores digests in one transaction. What is there already with the same trial, version and rules is left
  /// as it is. Throws DbError (kForeignKey) when there is no such trial.
  void add(std::span<const TrialDigest> digests);
  /// Reads those of the trials of a cohort, with this version of the formulas, by trial; several where rules
  /// differ.
  [[nodiscard]] std::multimap<std::string, TrialDigest> ofCohort(const CohortId& cohortId,
                                                                 std::int64_t formulaVersion) const;
  /// Reads those of one trial, with this version of the formulas; several where rules differ.
  [[nodiscard]] std::vector<TrialDigest> ofTrial(const TrialId& trialId, std::int64_t formulaVersion) const;
  /// Reads those of one trial that versions of the formulas before `formulaVersion` made, newest first.
  [[nodiscard]] std::vector<TrialDigest> olderOfTrial(const TrialId& trialId,
                                                      std::int64_t formulaVersion) const;

 private:
  Connection& connection_;
};

}  // namespace torsio
