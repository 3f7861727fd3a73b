// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "app/gui/base/page.h"
#include "app/gui/shell/main_window.h"
#include "tests/app/gui/support/founded_centre.h"
#include "tests/app/gui/support/program_window.h"

namespace torsio::gui {

inline constexpr const char* kStartPassword = "start with these words";
inline constexpr const char* kOwnPassword = "only I know this sentence";

/// A page without content, as a role's folder provides them to the shell.
class BarePage : public Page {
 public:
  BarePage(ShellContext& context, QString name) : Page(context), name_(std::move(name)) {
    setAccessibleName(name_);
  }
  void enter(const QVariant& argument) override {
    ++entered;
    argument_ = argument;
  }
  bool leave() override { return mayLeave; }
  bool busy() const override { return isBusy; }
  void retranslate() override {}
  ShellContext& context() { return shell(); }

  int entered = 0;
  int answered = 0;
  bool mayLeave = true;
  bool isBusy = false;
  QVariant argument_;

 protected:
  void customEvent(QEvent* event) override { answered += event->type() == databaseAnsweredEvent() ? 1 : 0; }

 private:
  QString name_;
};

inline PageEntry bareEntry(PageId id) {
  return {id, [id](ShellContext& context) -> Page* { return new BarePage(context, pageTitle(id)); }};
}

inline std::vector<PageGroup> bareGroups() {
  return {{[] { return QStringLiteral("Training"); },
           {bareEntry(PageId::kNextStep), bareEntry(PageId::kPractice)}},
          {[] { return QStringLiteral("Review"); }, {bareEntry(PageId::kQueue)}},
          {[] { return QStringLiteral("Administration"); },
           {bareEntry(PageId::kUsers), bareEntry(PageId::kAudit)}}};
}

/// The program's window with empty pages, on a separate record.
class Shell : public ::testing::Test {
 protected:
  QTemporaryDir folder_;
  ManualClock clock_;
  std::unique_ptr<MainWindow> window_;

  ShellSetup setup() {
    ShellSetup setup = testing::windowSetup(folder_.path().toStdString());
    setup.groups = bareGroups;
    setup.clock = &clock_;
    return setup;
  }

  void open(const ShellSetup& with) { window_ = testing::openWindow(with); }

  /// A centre with an administrator and a trainee with a start password, nobody signed in.
  void openFoundedCentre(ShellSetup with) {
    {
      const std::unique_ptr<SessionContext> office = foundCentre(with.locator.toStdString());
      addUser(*office, {.login = "chen", .roles = {"trainee"}, .startPassword = kStartPassword});
      torsio::signOut(*office);
    }
    open(with);
  }

  void enter(const QString& login, const QString& password) { testing::enter(*window_, login, password); }

  BarePage& page() { return static_cast<BarePage&>(*window_->desk()->page()); }
};

}  // namespace torsio::gui
