// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/base/page.h"

#include <QEvent>
#include <QStringList>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"

namespace torsio::gui {

Page::Page(ShellContext& shell, QWidget* parent) : QWidget(parent), shell_(shell) {
  QStringList roles;
  for (const std::string& role : shell.session().actor().roles) {
    roles << toQString(role);
  }
  setProperty("role", roles.join(QLatin1Char('+')));
}

void Page::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    retranslate();
  }
  QWidget::changeEvent(event);
}

}  // namespace torsio::gui
