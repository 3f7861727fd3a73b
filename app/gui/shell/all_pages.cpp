// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/all_pages.h"

#include <QCoreApplication>

#include "app/gui/shell/practice_page.h"

namespace torsio::gui {

namespace {

QString named(const char* text) {
  return QCoreApplication::translate("Desk", text);
}

}  // namespace

std::vector<PageGroup> allPages() {
  std::vector<PageEntry> station;
  station.push_back(practicePage());
  return {{[] { return named(QT_TRANSLATE_NOOP("Desk", "Training")); }, station},
          {[] { return named(QT_TRANSLATE_NOOP("Desk", "Review")); }, {}},
          {[] { return named(QT_TRANSLATE_NOOP("Desk", "Office")); }, {}}};
}

std::vector<ScreenEntry> allScreens() {
  return practiceScreens();
}

}  // namespace torsio::gui
