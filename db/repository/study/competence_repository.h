// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/competence_design.h"
#include "db/connection/connection.h"

namespace torsio {

/// Registered competence designs. Append-only.
class CompetenceRepository {
 public:
  explicit CompetenceRepository(Connection& connection) : connection_(connection) {}

  /// Stores `design` as the next version of its module and returns it with its number. Throws DbError if the
  /// module does not exist.
  CompetenceDesign add(CompetenceDesign design);
  /// Returns the designs of a module, oldest first.
  [[nodiscard]] std::vector<CompetenceDesign> ofModule(const ModuleId& moduleId) const;

 private:
  Connection& connection_;
};

}  // namespace torsio
