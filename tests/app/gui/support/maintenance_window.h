// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <gtest/gtest.h>

#include "app/gui/administrator/administrator_pages.h"
#include "app/gui/administrator/station/maintenance_page.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/shell/main_window.h"
#include "app/services/access/centre_settings.h"
#include "app/services/people/people_service.h"
#include "assessment/domain/people/audit_entry.h"
#include "assessment/domain/study/station_state.h"
#include "db/connection/connection.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/trial/station_repository.h"
#include "tests/app/gui/support/founded_centre.h"
#include "tests/app/gui/support/program_window.h"

namespace torsio::gui {

namespace fs = std::filesystem;

/// The program's window with administrators' pages, an administrator signed in, and a record of two people.
class MaintenancePages : public ::testing::Test {
 protected:
  QTemporaryDir folder_;
  ManualClock clock_;
  std::unique_ptr<MainWindow> window_;
  QStringList failures_;

  [[nodiscard]] fs::path in(const char* name) const { return toPath(folder_.path()) / name; }
  [[nodiscard]] std::string record() const { return in("torsio.sqlite").string(); }

  void SetUp() override {
    {
      const std::unique_ptr<SessionContext> office = foundCentre(record());
      office->beginCall();
      setCentreSetting<kTwoPeople>(*office, false);  // there is only one administrator
      addPerson(*office, person());
      addPerson(*office, person());
    }
    ShellSetup setup = testing::windowSetup(toPath(folder_.path()));
    setup.groups = [] {
      return std::vector<PageGroup>{{[] { return QStringLiteral("Administration"); }, administratorPages()}};
    };
    setup.clock = &clock_;
    setup.lessonsAgain = std::chrono::hours(24);
    window_ = testing::openWindow(setup);
    signIn();
  }

  static PersonEntry person() {
    PersonEntry entry{.fullName = "Li Na"};
    return entry;
  }

  void signIn() {
    ASSERT_EQ(testing::screenOf(*window_), QStringLiteral("sign-in"));
    testing::enter(*window_, QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
    ASSERT_EQ(testing::screenOf(*window_), QStringLiteral("desk"));
    QObject::connect(&context(), &ShellContext::failed, window_.get(),
                     [this](const QString& happened) { failures_ << happened; });
  }

  ShellContext& context() { return window_->desk()->context(); }

  /// Opens a page by its button on the maintenance page.
  template <typename Made>
  Made& openBy(const char* button) {
    window_->desk()->open(PageId::kMaintenance);
    press(*window_->desk()->page(), button);
    return dynamic_cast<Made&>(*window_->desk()->page());
  }

  MaintenancePage& maintenancePage() {
    window_->desk()->open(PageId::kMaintenance);
    return dynamic_cast<MaintenancePage&>(*window_->desk()->page());
  }

  void press(QWidget& in, const char* text) { testing::press(in, QLatin1String(text)); }

  void click(QPushButton& button) {
    ASSERT_TRUE(button.isVisible() && button.isEnabled()) << button.text().toStdString();
    QTest::mouseClick(&button, Qt::LeftButton);
    context().waitForJobs();
  }

  /// Cancels the button's job before its first step: clicking "Cancel" would be a race.
  void clickAndCancel(QPushButton& button) {
    QObject::connect(
        &context(), &ShellContext::jobStarted, &button, [this] { context().cancelJobs(); },
        Qt::SingleShotConnection);
    click(button);
  }

  bool says(const QString& part) { return testing::says(*window_, part); }

  std::vector<std::string> trail(const std::string& locator) {
    Connection connection = openDatabase(locator, OpenMode::kReadOnly);
    std::vector<std::string> actions;
    for (const AuditEntry& entry : AuditRepository(connection).entries()) {
      actions.push_back(entry.action);
    }
    return actions;
  }

  static std::int64_t people(const std::string& locator) {
    Connection connection = openDatabase(locator, OpenMode::kReadOnly);
    Statement row = connection.prepare("SELECT count(*) FROM trainee");
    row.execute();
    std::int64_t count = 0;
    while (row.step()) {
      count = row.int64(0);
    }
    return count;
  }

  void showsOtherStation() {
    StationState other{.station = "room 2", .heartbeatUtc_us = window_->session()->now_us()};
    StationRepository(window_->session()->connectionWithoutRight()).heartbeat(other);
  }

  [[nodiscard]] int filesBeside() const {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(folder_.path().toStdString())) {
      static_cast<void>(entry);
      ++count;
    }
    return count;
  }
};

inline bool contains(const std::vector<std::string>& actions, const std::string& action) {
  return std::find(actions.begin(), actions.end(), action) != actions.end();
}

}  // namespace torsio::gui
