// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/gui/base/page.h"
#include "app/services/maintenance/database_maintenance.h"
#include "app/services/maintenance/retention.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace torsio::gui {

class Card;
class PageHeading;
class RetentionQueue;

/// Maintenance: backup and its test, database check, disk space, simulated data, and records due for review.
class MaintenancePage : public Page {
  Q_OBJECT

 public:
  explicit MaintenancePage(ShellContext& shell);

  void enter(const QVariant& argument) override;
  void retranslate() override;

  void backUp(const std::filesystem::path& file);
  void testBackup(const std::filesystem::path& file);
  void checkRecord();
  void checkComputer();
  void saveSupportReport(const QString& file);
  bool removeDemonstration(const std::string& reason);

 private:
  QWidget* cards();
  void read();
  void showRecord();
  void showButtons();
  void askBackUp();
  void askTest();
  void askRemoveDemonstration();
  void askTakeBack();

  std::optional<DatabaseCheck> check_;
  DemonstrationSize demonstration_;
  PageHeading* heading_;
  Card* record_;
  QLabel* recordText_;
  QProgressBar* disk_;
  QLabel* diskText_;
  QPushButton* checkButton_;
  QPushButton* computerButton_;
  Card* backup_;
  QLabel* backupText_;
  QPushButton* backupButton_;
  QPushButton* testButton_;
  Card* simulated_;
  QLabel* simulatedText_;
  QPushButton* removeButton_;
  Card* move_;
  QLabel* moveText_;
  QPushButton* restoreButton_;
  QPushButton* moveButton_;
  QPushButton* takeBackButton_;
  RetentionQueue* queue_;
};

}  // namespace torsio::gui
