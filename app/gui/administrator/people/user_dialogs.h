// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QString>
#include <QStringList>

#include "app/services/access/access_service.h"
#include "app/services/people/people_service.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"

class QWidget;

namespace torsio::gui {

/// Returns the name of a role in the user's language; the code of an unknown one.
[[nodiscard]] QString roleName(const std::string& code);

/// A person of the record to link to an account.
struct PersonChoice {
  PersonId personId{};
  QString label;  ///< "T-07 · Li Na", or only the code
};

/// Asks for sign-in name, roles and person. Empty: cancelled.
[[nodiscard]] std::optional<NewUser> askNewUser(QWidget* parent, const std::vector<PersonChoice>& people);

struct RolesChange {
  std::vector<std::string> roles{};
  std::string reason{};
};
[[nodiscard]] std::optional<RolesChange> askRoles(QWidget* parent, const QString& login,
                                                  const std::vector<std::string>& roles);

struct PersonEdit {
  PersonEntry entry{};
  std::string reason{};  ///< of a change; empty for a new person
};

/// Asks for all data of a person. `present`: the person to edit; empty: a new one. Returns nothing if
/// cancelled.
[[nodiscard]] std::optional<PersonEdit> askPerson(QWidget* parent, const std::optional<PersonEntry>& present,
                                                  const std::vector<SeniorityClass>& classes);

}  // namespace torsio::gui
