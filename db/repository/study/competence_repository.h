// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/competence_design.h"
#include "db/connection/connection.h"

namespace torsio {

/// Registered competence designs. They are only added to, and never change.
class CompetenceRepository {
 public:
  explicit CompetenceRepository(Connection& connection) : connection_(connection) {}

  /// Stores `design` as the next version of its module and returns it with that number. Throws DbError when
  /// there is no such module.
  CompetenceDesign add(CompetenceDesign design);
  /// Reads the designs of a module, oldest first.
  [[nodiscard]] std::vector<CompetenceDesign> ofModule(const ModuleId& moduleId) const;

 private:
  Connection& connection_;
};

}  // namespace torsio
