// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "db/connection/connection.h"

namespace torsio {

/// A named state of a cohort's data. Append-only.
struct StoredFreeze {
  std::string id{};
  std::string cohortId{};
  std::string name{};         ///< unique in the record
  std::string contentHash{};  ///< BLAKE2b-256 over what went into it
  std::string manifestJson{};
  std::string createdBy{};
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
};

/// Frozen data sets. Each is told of in the audit trail in the same transaction.
class FreezeRepository {
 public:
  /// `station`: for the audit trail.
  explicit FreezeRepository(Connection& connection, std::string station = {})
      : connection_(connection), station_(std::move(station)) {}

  /// Stores a frozen data set; storing it once more is no error. Throws DbError (kUnique) when the name is
  /// taken or the id has other content.
  void add(const StoredFreeze& freeze);
  [[nodiscard]] std::optional<StoredFreeze> findByName(const std::string& name) const;
  /// Of one cohort, oldest first.
  [[nodiscard]] std::vector<StoredFreeze> list(const std::string& cohortId) const;

 private:
  Connection& connection_;
  std::string station_;
};

}  // namespace torsio
