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

/// What was measured of one recording, with the formula and the tolerance that it was judged by.
struct StoredTrialDigest {
  std::string trialId{};
  std::string formulaVersion{};
  double tolerance_rad = 0.0;
  std::string contentHash{};  ///< of the recording that was measured
  std::string model{};
  double minutes = 0.0;
  std::optional<double> meanAbsoluteError_deg{};
  std::optional<double> peakTorque_Nm{};
  std::optional<double> peakForce_N{};
  /// In their order: absolute error in degrees, on target.
  std::vector<std::pair<double, bool>> attempts{};
  std::int64_t computedUtc_us = 0;
  friend bool operator==(const StoredTrialDigest&, const StoredTrialDigest&) = default;
};

/// Digests of recordings. Append-only: another formula or tolerance adds a row.
class DigestRepository {
 public:
  explicit DigestRepository(Connection& connection) : connection_(connection) {}

  /// One transaction. What is there already with the same trial, formula and tolerance is left as it is.
  /// Throws DbError (kForeignKey) when there is no such trial.
  void add(std::span<const StoredTrialDigest> digests);
  /// Of the trials of a cohort, with this version of the formula, by trial; several where tolerances differ.
  [[nodiscard]] std::multimap<std::string, StoredTrialDigest> ofCohort(
      const std::string& cohortId, const std::string& formulaVersion) const;

  /// The cohort for which an enrolment counts; empty: there is no such enrolment.
  [[nodiscard]] std::string cohortOf(const std::string& enrolmentId) const;

 private:
  Connection& connection_;
};

}  // namespace torsio
