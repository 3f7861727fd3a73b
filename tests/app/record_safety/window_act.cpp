// SPDX-License-Identifier: GPL-3.0-or-later
// A maintenance operation that only the window has, in a separate program that can be killed:
//   window_act erase|remove-demonstration|package|allocate|first-run|open LOCATOR LOGIN PASSWORD [SUBJECT
//   [FOLDER]]
// SUBJECT: a person or a cohort; open: brings the schema up to date.
#include <iostream>
#include <string>
#include <vector>

#include <QCoreApplication>

#include "app/services/access/first_run.h"
#include "app/services/base/assets.h"
#include "app/services/demonstration/demonstration.h"
#include "app/services/maintenance/maintenance_desk.h"
#include "app/services/maintenance/person_package.h"
#include "app/services/maintenance/retention.h"
#include "app/services/study/allocation_service.h"
#include "sim/core/error.h"

namespace torsio {
namespace {

/// Runs the last step of the first-run wizard, with simulated people who train briefly.
void setUp(const std::vector<std::string>& words) {
  SessionContext session(SessionKey{.locator = words.at(1), .station = "station"});
  session.setPasswordCost(PasswordCost::kTest);
  const FirstRun first{
      .centre = "Skills laboratory", .login = words.at(2), .password = words.at(3), .demonstration = true};
  (void)performFirstRun(session, first, [](SessionContext& own) {
    DemonstrationOptions options;
    options.training.assets = assetsFolder();
    options.training.id = "forearm";
    options.example.assets = options.training.assets;
    options.example.id = "stomach";
    options.shortening = 600;
    (void)fillDemonstration(options, own.connectionWithoutRight());
    return std::vector<StartAccount>{};
  });
}

void act(const std::vector<std::string>& words) {
  if (words.at(0) == "first-run") {
    setUp(words);
    return;
  }
  if (words.at(0) == "open") {
    (void)openUpToDate(words.at(1));
    return;
  }
  MaintenanceDesk desk({.login = words.at(2), .password = [&words] { return words.at(3); }}, words.at(1));
  if (words.at(0) == "erase") {
    erasePersonRecord(desk.session(), words.at(4), "asked for it");
  } else if (words.at(0) == "package") {
    (void)exportPersonPackage(desk.session(), words.at(4), words.at(5), "asked for it");
  } else if (words.at(0) == "allocate") {
    (void)allocateAll(desk.session(), words.at(4));
  } else {
    (void)removeDemonstrationData(desk.session(), "the centre begins");
  }
}

}  // namespace
}  // namespace torsio

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  try {
    torsio::act({argv + 1, argv + argc});
  } catch (const torsio::Error& error) {
    std::cerr << "torsio: " << error.what() << "\n";
    return static_cast<int>(error.code());
  }
  return 0;
}
