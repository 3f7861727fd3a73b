// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QString>

#include "app/services/maintenance/retention.h"
#include "assessment/domain/people/retention.h"

class QWidget;

namespace torsio::gui {

/// Names a category of records in the user's language; the code for an unknown one.
[[nodiscard]] QString retentionCategoryName(const std::string& code);

/// What an administrator decided about the rules for keeping records.
struct RetentionRulesEdit {
  std::vector<RetentionRule> set{};    ///< new or changed
  std::vector<std::string> removed{};  ///< categories whose records are kept without limit from now on
};
/// Asks how long the records of each category are kept and on what lawful basis. Fields are called by their
/// category: "trainee" (whether), "trainee.days", "trainee.basis". Empty: given up.
[[nodiscard]] std::optional<RetentionRulesEdit> askRetentionRules(QWidget* parent,
                                                                  const std::vector<RetentionRule>& rules);

}  // namespace torsio::gui
