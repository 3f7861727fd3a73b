// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QString>
#include <QStringList>

#include "app/services/access/access_service.h"
#include "assessment/domain/ids.h"

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

}  // namespace torsio::gui
