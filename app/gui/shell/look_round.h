// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QTemporaryDir>

#include "app/gui/base/language.h"
#include "app/gui/shell/first_run_panel.h"
#include "app/gui/shell/visit_bar.h"
#include "app/services/access/session_context.h"

namespace torsio::gui {

/// A temporary record of simulated people for a visitor; its folder is deleted with it.
struct LookRound {
  [[nodiscard]] FirstRunChoice choice(const QString& centre, Language language) const {
    FirstRunChoice choice;
    choice.locator = folder.filePath(QStringLiteral("torsio.sqlite"));
    choice.first.centre = centre.toStdString();
    choice.first.login = "visitor";
    choice.first.password = randomStartPassword();
    choice.first.language = languageCode(language).toStdString();
    choice.first.demonstration = true;
    return choice;
  }

  QTemporaryDir folder{};
  QString before{};  ///< locator to restore afterwards
  Actor visitor{};   ///< the visitor, even when seen as a simulated person
  VisitedDesk first = VisitedDesk::kAdministrator;
};

}  // namespace torsio::gui
