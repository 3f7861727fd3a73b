// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/domain/people/retention.h"
#include "db/connection/connection.h"

namespace torsio {

/// Retention rules, what is due, and what was decided about it. Erases nothing: erasePerson does. Simulated
/// people are never due; they go with the demonstration.
class RetentionRepository {
 public:
  explicit RetentionRepository(Connection& connection) : connection_(connection) {}

  /// Adds or replaces the rule of its category. Throws Error (kBadParameter) for an unknown category, less
  /// than one day or more than a hundred years.
  void setRule(const RetentionRule& rule);
  void removeRule(const std::string& category);
  [[nodiscard]] std::vector<RetentionRule> rules() const;

  /// Throws DbError: kForeignKey (no such person), kCheck (kExtend without its end).
  void addHold(const RetentionHold& hold);

  /// Everybody whose record is due at `utc_us` by some rule, those who are held among them; longest due
  /// first.
  [[nodiscard]] std::vector<RetentionItem> due(std::int64_t utc_us) const;

 private:
  Connection& connection_;
};

}  // namespace torsio
