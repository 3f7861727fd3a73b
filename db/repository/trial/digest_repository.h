// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "db/connection/connection.h"

namespace torsio {

/// Everything that was measured of one recording, with the version of the formulas and the rules that it was
/// judged by.
struct StoredTrialDigest {
  std::string trialId{};
  std::int64_t formulaVersion = 0;
  double tolerance_rad = 0.0;
  std::optional<double> forceLimit_N{};    ///< at least 0; empty: none
  std::optional<double> torqueLimit_Nm{};  ///< at least 0; empty: none
  std::string contentHash{};               ///< of the recording that was measured
  std::string model{};
  std::int64_t duration_us = 0;
  std::int64_t unfinishedTwists = 0;
  std::optional<double> meanAbsoluteError_deg{};
  std::optional<double> peakTorque_Nm{};
  std::optional<double> peakForce_N{};
  /// Completed twists in their order: absolute error in degrees, on target.
  std::vector<std::pair<double, bool>> attempts{};
  std::map<std::string, double> measures{};  ///< by metric id of at most 255 bytes
  std::int64_t computedUtc_us = 0;
  friend bool operator==(const StoredTrialDigest&, const StoredTrialDigest&) = default;
};

/// What a module of a curriculum asks of a run.
struct StoredExerciseRules {
  double tolerance_rad = 0.0;
  std::int64_t hold_us = 0;
  std::optional<double> forceLimit_N{};
  std::optional<double> torqueLimit_Nm{};
};

/// Digests of recordings. Append-only: another version of the formulas or other rules add a row.
class DigestRepository {
 public:
  explicit DigestRepository(Connection& connection) : connection_(connection) {}

  /// Stores digests in one transaction. What is there already with the same trial, version and rules is left
  /// as it is. Throws DbError (kForeignKey) when there is no such trial.
  void add(std::span<const StoredTrialDigest> digests);
  /// Reads those of the trials of a cohort, with this version of the formulas, by trial; several where rules
  /// differ.
  [[nodiscard]] std::multimap<std::string, StoredTrialDigest> ofCohort(const std::string& cohortId,
                                                                       std::int64_t formulaVersion) const;
  /// Reads those of one trial, with this version of the formulas; several where rules differ.
  [[nodiscard]] std::vector<StoredTrialDigest> ofTrial(const std::string& trialId,
                                                       std::int64_t formulaVersion) const;

  /// Reads what a module asks of a run; empty: there is no such module.
  [[nodiscard]] std::optional<StoredExerciseRules> rulesOfModule(const std::string& moduleId) const;

 private:
  Connection& connection_;
};

}  // namespace torsio
