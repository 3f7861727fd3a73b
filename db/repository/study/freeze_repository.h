// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/cohort.h"
#include "db/connection/connection.h"

namespace torsio {

/// Frozen data sets. Each is recorded in the audit trail in the same transaction.
class FreezeRepository {
 public:
  /// `station`: for the audit trail.
  explicit FreezeRepository(Connection& connection, std::string station = {})
      : connection_(connection), station_(std::move(station)) {}

  /// Stores a frozen data set; storing it again is no error. Throws DbError (kUnique) if the name is taken or
  /// the id has other content.
  void add(const DataFreeze& freeze);
  [[nodiscard]] std::optional<DataFreeze> findByName(const std::string& name) const;
  /// Frozen data sets of a cohort, oldest first.
  [[nodiscard]] std::vector<DataFreeze> list(const CohortId& cohortId) const;

 private:
  Connection& connection_;
  std::string station_;
};

}  // namespace torsio
