// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/program/all_pages.h"

#include <QCoreApplication>

#include "app/gui/administrator/administrator_pages.h"
#include "app/gui/physician/review_pages.h"
#include "app/gui/practice/compare_page.h"
#include "app/gui/practice/practice_page.h"
#include "app/gui/trainee/station_desk.h"
#include "app/gui/trainee/station_pages.h"

namespace torsio::gui {

namespace {

QString named(const char* text) {
  return QCoreApplication::translate("Desk", text);
}

}  // namespace

std::vector<PageGroup> allPages() {
  const std::shared_ptr<StationDesk> desk = deskOfThisStation();
  std::vector<PageEntry> training = stationPages(desk);
  training.push_back(practicePage(desk));
  training.push_back(comparePage());
  return {{[] { return named(QT_TRANSLATE_NOOP("Desk", "Training")); }, training},
          {[] { return named(QT_TRANSLATE_NOOP("Desk", "Review")); }, reviewPages()},
          {[] { return named(QT_TRANSLATE_NOOP("Desk", "Administration")); }, administratorPages()}};
}

std::vector<ScreenEntry> allScreens() {
  std::vector<ScreenEntry> screens = stationScreens();
  for (const std::vector<ScreenEntry>& more :
       {practiceScreens(), organScreens(), compareScreens(), reviewScreens(), administratorScreens()}) {
    screens.insert(screens.end(), more.begin(), more.end());
  }
  return screens;
}

std::vector<ScreenEntry> allDialogs() {
  return administratorDialogs();
}

}  // namespace torsio::gui
