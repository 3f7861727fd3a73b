// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <system_error>
#include <unistd.h>

#include <QLabel>
#include <QPushButton>
#include <gtest/gtest.h>

#include "app/gui/organ/organ_wizard.h"
#include "tests/app/gui/support/watched_shell.h"
#include "tests/app/support/study_centre.h"

namespace torsio::gui::testing {

/// A folder of this program, removed when it ends.
struct WizardFolder {
  std::filesystem::path path =
      std::filesystem::path(::testing::TempDir()) / ("wizard-" + std::to_string(getpid()));
  WizardFolder() { std::filesystem::create_directories(path); }
  WizardFolder(const WizardFolder&) = delete;
  WizardFolder& operator=(const WizardFolder&) = delete;
  ~WizardFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
};

/// Returns a file in that folder.
inline std::filesystem::path wizardFile(const std::string& name) {
  static const WizardFolder kFolder;
  return kFolder.path / name;
}

/// Returns all visible text of the wizard.
inline std::string readable(const OrganWizard& wizard) {
  QString all;
  for (const QLabel* label : wizard.findChildren<QLabel*>()) {
    if (label->isVisibleTo(&wizard)) {
      all += label->text() + QLatin1Char('\n');
    }
  }
  return all.toStdString();
}

inline QPushButton& wizardButton(const OrganWizard& wizard, const QString& text) {
  for (QPushButton* one : wizard.findChildren<QPushButton*>()) {
    if (one->text() == text) {
      return *one;
    }
  }
  ADD_FAILURE() << "no button " << text.toStdString();
  return *wizard.findChild<QPushButton*>();
}

/// A desk with the wizard.
class OrganDesk {
 public:
  OrganDesk() {
    wizard.resize(1366, 768);
    wizard.retranslate();
    wizard.begin();
  }
  void judge(const std::filesystem::path& file) {
    wizard.judgeMesh(file);
    settle();
  }
  void again() {
    wizardButton(wizard, QStringLiteral("Check again")).click();
    settle();
  }
  void openInstrument(const std::filesystem::path& source) {
    wizard.openInstrument(source);
    settle();
  }
  void findInstrument() {
    wizard.findInstrument();
    settle();
  }
  void makeArm() {
    wizardButton(wizard, QStringLiteral("Draw the arm")).click();
    settle();
  }
  void openScan(const std::filesystem::path& source) {
    wizard.openScan(source);
    settle();
  }
  void find() {
    wizard.findOrgan();
    settle();
  }
  void makeSurface() {
    wizard.makeSurface();
    settle();
  }

  void settle() { watched_.settle(); }

 private:
  torsio::testing::StudyCentre centre_;
  WatchedShell watched_{centre_.session()};

 public:
  OrganWizard wizard{watched_.shell()};
  QStringList& failures = watched_.failures;
};

}  // namespace torsio::gui::testing
