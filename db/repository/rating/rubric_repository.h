// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/rubric.h"
#include "db/connection/connection.h"

namespace torsio {

/// Rubrics and their immutable revisions. Each call is one transaction.
class RubricRepository {
 public:
  explicit RubricRepository(Connection& connection) : connection_(connection) {}

  void addRubric(const std::string& id, const std::string& name, std::int64_t createdUtc_us,
                 bool demonstration);
  /// All rubrics, by name.
  [[nodiscard]] std::vector<Rubric> rubrics() const;
  void addRevision(const RubricRevision& revision);
  [[nodiscard]] std::optional<RubricRevision> revision(const RubricRevisionId& revisionId) const;
  /// Ids of a rubric's revisions, oldest first.
  [[nodiscard]] std::vector<RubricRevisionId> revisionIds(const RubricId& rubricId) const;

 private:
  Connection& connection_;
};

}  // namespace torsio
