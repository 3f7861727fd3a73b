// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/gui/base/page.h"
#include "app/gui/base/table_choice.h"
#include "app/services/access/audit_service.h"
#include "assessment/domain/people/audit_entry.h"

class QComboBox;
class QDateEdit;
class QLabel;
class QPlainTextEdit;
class QPushButton;
class QToolButton;

namespace torsio::gui {

class DataTable;
class PageHeading;

/// Who did what when, and whether anything was changed behind the program's back.
class AuditPage : public Page {
  Q_OBJECT

 public:
  explicit AuditPage(ShellContext& shell);

  void enter(const QVariant& argument) override;
  void retranslate() override;
  /// Writes what the chosen time holds.
  bool exportTo(const std::filesystem::path& file, const CsvStyle& look = {});

 private:
  void read();
  void readMore();
  void showContent();
  void showEntry(const QString& id);
  void verify();
  void showVerdict();
  /// "person T-30"; without a code, the kind alone.
  [[nodiscard]] QString objectText(const AuditEntry& entry) const;
  void askExport();
  /// The time that is chosen, without a limit.
  [[nodiscard]] AuditFilter chosenTime() const;

  std::vector<AuditEntry> entries_;
  std::int64_t most_;     // of them are read
  std::int64_t all_ = 0;  // of the chosen time are there
  std::map<std::string, std::string> logins_;
  std::map<std::string, std::string> subjects_;        // codes by ids of objects
  std::optional<std::vector<AuditFinding>> findings_;  // empty: not looked for yet
  PageHeading* heading_;
  QPushButton* verify_;
  QPushButton* heads_;
  QLabel* verdict_;
  QComboBox* days_;
  QDateEdit* from_;
  QDateEdit* to_;
  QPushButton* export_;
  QToolButton* more_;
  DataTable* table_;
  QPlainTextEdit* entry_;
};

}  // namespace torsio::gui
