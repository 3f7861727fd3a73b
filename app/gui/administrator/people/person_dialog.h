// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QString>

#include "app/services/people/people_service.h"
#include "assessment/domain/people/person.h"

class QWidget;

namespace torsio::gui {

struct PersonEdit {
  PersonEntry entry{};
  std::string reason{};  ///< of a change; empty for a new person
};

/// Asks for all data of a person. `present`: the person to edit; empty: a new one. Returns nothing if
/// cancelled.
[[nodiscard]] std::optional<PersonEdit> askPerson(QWidget* parent, const std::optional<PersonEntry>& present,
                                                  const std::vector<SeniorityClass>& classes);

}  // namespace torsio::gui
