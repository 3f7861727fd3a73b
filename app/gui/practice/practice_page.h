// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "app/gui/base/page.h"
#include "app/gui/practice/simulator_window.h"

namespace torsio {
class TrialStore;
}
class QStackedWidget;

namespace torsio::gui {

class OrganWizard;
class StationDesk;

/// Free practice on any organ: the simulator without curriculum. Never stored as a trial, never scored. Users
/// signed in with a password may record a try and replay it until sign-out; with a PIN or as a guest nothing
/// is recorded.
class PracticePage : public Page {
  Q_OBJECT

 public:
  /// `desk`: read only here, for the device.
  PracticePage(ShellContext& shell, const StationDesk& desk, QWidget* parent = nullptr);
  ~PracticePage() override;

  void enter(const QVariant& argument) override;
  [[nodiscard]] bool leave() override;
  [[nodiscard]] std::vector<std::pair<QString, QString>> keys() const override;
  void retranslate() override;
  void applyTheme(const Theme& theme) override;
  /// Shows the organ wizard in place of the simulator; creates it on first use.
  OrganWizard& bringOrgan();

 private:
  void showSimulator();
  [[nodiscard]] TrialRecording recording();

  std::shared_ptr<TrialStore> store_;
  std::shared_ptr<std::set<std::string>> own_;  // trial ids of this sign-in
  QStackedWidget* pages_;
  SimulatorWindow* simulator_ = nullptr;
  OrganWizard* wizard_ = nullptr;
};

/// For all users who may practise.
[[nodiscard]] PageEntry practicePage(std::shared_ptr<StationDesk> desk);
[[nodiscard]] std::vector<ScreenEntry> practiceScreens();
[[nodiscard]] std::vector<ScreenEntry> organScreens();

}  // namespace torsio::gui
