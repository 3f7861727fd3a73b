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

/// Shows a start password, or the half that the actor may know, once, with a copy button.
enum class PasswordPart { kWhole, kFirstHalf, kSecondHalf };
void showStartPassword(QWidget* parent, const QString& login, const QString& password,
                       PasswordPart part = PasswordPart::kWhole);

/// Runs `act`. If a second person is needed and has not been asked, offers to ask, and shows the first half
/// of a start password if one is made for `login`. Returns true if `act` succeeded. Throws any other error of
/// `act`.
bool actOrAsk(QWidget* parent, ShellContext& shell, const DutyWish& wish, const std::function<void()>& act,
              const QString& login = {});
/// Like actOrAsk() for several wishes without start passwords: `act` handles one of them; for those that need
/// a second person, offers once to ask. Returns how many were done.
std::size_t actOrAskForAll(QWidget* parent, ShellContext& shell, const std::vector<DutyWish>& wishes,
                           const std::function<void(const DutyWish&)>& act);
/// Offers once to ask a second person for several wishes without start passwords. Returns true if asked.
/// Throws Error.
bool offerToAskForAll(QWidget* parent, ShellContext& shell, const std::vector<DutyWish>& wishes);
/// Offers to ask a second person. Returns true if asked. Throws Error.
bool offerToAsk(QWidget* parent, ShellContext& shell, const DutyWish& wish, const QString& login = {});

}  // namespace torsio::gui
