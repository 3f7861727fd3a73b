// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <QString>

#include "app/services/access/two_people.h"

class QWidget;

namespace torsio::gui {

class ShellContext;

/// Shows a start password, or the half of one that the actor may know, once, with a button that copies it.
enum class PasswordPart { kWhole, kFirstHalf, kSecondHalf };
void showStartPassword(QWidget* parent, const QString& login, const QString& password,
                       PasswordPart part = PasswordPart::kWhole);

/// Does what one person may do. Where a second one is needed and has not asked yet, offers to ask for it, and
/// shows the first half of a start password when there is one; `login`: whose. True when it was done. Throws
/// what `act` throws else.
bool actOrAsk(QWidget* parent, ShellContext& shell, const DutyWish& wish, const std::function<void()>& act,
              const QString& login = {});
/// The same of several things, of which none makes a start password: `act` does one of them; for those that
/// need a second person it is offered once to ask. Returns how many were done.
std::size_t actOrAskForAll(QWidget* parent, ShellContext& shell, const std::vector<DutyWish>& wishes,
                           const std::function<void(const DutyWish&)>& act);
/// Offers once to ask a second person for several things, of which none makes a start password; true when
/// asked. Throws Error.
bool offerToAskForAll(QWidget* parent, ShellContext& shell, const std::vector<DutyWish>& wishes);
/// Offers to ask a second person; true when asked. Throws Error.
bool offerToAsk(QWidget* parent, ShellContext& shell, const DutyWish& wish, const QString& login = {});

}  // namespace torsio::gui
