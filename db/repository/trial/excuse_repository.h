// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "assessment/domain/ids.h"
#include "db/connection/connection.h"

namespace torsio {

/// Why an interrupted run does not count as failed.
struct RunExcuse {
  TrialId trialId{};
  std::string excusedBy{};
  std::int64_t excusedUtc_us = 0;
  std::string reason{};  ///< empty: erased
};

/// Excuses of interrupted runs. Append-only, one for each run.
class ExcuseRepository {
 public:
  explicit ExcuseRepository(Connection& connection) : connection_(connection) {}

  /// Throws DbError if the trial does not exist or is excused already.
  void add(const RunExcuse& excuse);
  [[nodiscard]] std::optional<RunExcuse> of(const TrialId& trialId) const;

 private:
  Connection& connection_;
};

}  // namespace torsio
