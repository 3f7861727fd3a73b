// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/people/retention.h"
#include "db/connection/connection.h"

namespace torsio {

/// Retention rules, due records, and decisions about them. Erases nothing (erasePerson does). Simulated
/// people are never due; they are removed with the demonstration.
class RetentionRepository {
 public:
  explicit RetentionRepository(Connection& connection) : connection_(connection) {}

  /// Adds or replaces the rule of its category. Throws Error (kBadParameter) for an unknown category or a
  /// period below one day or above a hundred years.
  void setRule(const RetentionRule& rule);
  void removeRule(const std::string& category);
  [[nodiscard]] std::vector<RetentionRule> rules() const;

  /// Throws DbError: kForeignKey (no such person), kCheck (kExtend without an end).
  void addHold(const RetentionHold& hold);

  /// Returns everybody whose record is due at `utc_us`, including those on hold; longest overdue first.
  [[nodiscard]] std::vector<RetentionItem> due(std::int64_t utc_us) const;

 private:
  Connection& connection_;
};

/// People's requests about their own records. Each call is one transaction.
class RequestRepository {
 public:
  explicit RequestRepository(Connection& connection) : connection_(connection) {}

  void add(const PersonRequest& request);
  /// Throws Error{kBadData} if it was already answered.
  void answer(const std::string& requestId, PersonRequestAnswer answer, const std::string& reason,
              std::int64_t utc_us);
  /// Newest first.
  [[nodiscard]] std::vector<PersonRequest> all() const;

 private:
  Connection& connection_;
};

}  // namespace torsio
