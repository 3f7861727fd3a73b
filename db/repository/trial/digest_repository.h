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

/// Digests of recordings. Append-only: other formulas or rules add a row.
class DigestRepository {
 public:
  explicit DigestRepository(Connection& connection) : connection_(connection) {}

  /// Stores digests in one transaction; existing ones of the same trial, version and rules are left alone.
  /// Throws DbError (kForeignKey) if a trial does not exist.
  void add(std::span<const TrialDigest> digests);
  /// Returns the digests of a cohort's trials with this formula version, by trial; several if rules differ.
  [[nodiscard]] std::multimap<std::string, TrialDigest> ofCohort(const CohortId& cohortId,
                                                                 std::int64_t formulaVersion) const;
  /// Returns the digests of one trial with this formula version; several if rules differ.
  [[nodiscard]] std::vector<TrialDigest> ofTrial(const TrialId& trialId, std::int64_t formulaVersion) const;
  /// Returns the digests of one trial with older formula versions, newest first.
  [[nodiscard]] std::vector<TrialDigest> olderOfTrial(const TrialId& trialId,
                                                      std::int64_t formulaVersion) const;

 private:
  Connection& connection_;
};

}  // namespace torsio
