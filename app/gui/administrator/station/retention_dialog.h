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

/// Names a category of records in the user's language; the code of an unknown one.
[[nodiscard]] QString retentionCategoryName(const std::string& code);

/// An administrator's changes to the retention rules.
struct RetentionRulesEdit {
  std::vector<RetentionRule> set{};    ///< new or changed
  std::vector<std::string> removed{};  ///< categories now kept without limit
};
/// Asks for retention period and lawful basis of each category. Object names of fields: "trainee" (enabled),
/// "trainee.days", "trainee.basis". Empty: cancelled.
[[nodiscard]] std::optional<RetentionRulesEdit> askRetentionRules(QWidget* parent,
                                                                  const std::vector<RetentionRule>& rules);

}  // namespace torsio::gui
