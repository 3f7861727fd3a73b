// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QString>

#include "app/services/study/cohort_service.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/cohort.h"

class QWidget;

namespace torsio::gui {

/// A trainee's manual move to another group.
struct GroupMove {
  GroupId groupId{};
  std::string reason{};
};
/// Asks for target group and reason. `groups`: possible targets. Empty: cancelled.
[[nodiscard]] std::optional<GroupMove> askGroupMove(QWidget* parent, const QString& codes,
                                                    const std::vector<StudyGroup>& groups);

}  // namespace torsio::gui
