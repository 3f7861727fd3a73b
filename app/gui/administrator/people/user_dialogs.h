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

/// Name of a role in the user's language; the code for an unknown one.
[[nodiscard]] QString roleName(const std::string& code);

/// A person of the record whom a user may be.
struct PersonChoice {
  PersonId personId{};
  QString label;  ///< "T-07 · Li Na", or the code alone
};

/// Asks for sign-in name, roles and person. Empty: given up.
[[nodiscard]] std::optional<NewUser> askNewUser(QWidget* parent, const std::vector<PersonChoice>& people);

struct RolesChange {
  std::vector<std::string> roles{};
  std::string reason{};
};
[[nodiscard]] std::optional<RolesChange> askRoles(QWidget* parent, const QString& login,
                                                  const std::vector<std::string>& roles);

}  // namespace torsio::gui
