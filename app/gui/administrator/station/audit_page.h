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

/// The audit trail, and the check for manipulation outside the program.
class AuditPage : public Page {
  Q_OBJECT

 public:
  explicit AuditPage(ShellContext& shell);

  void enter(const QVariant& argument) override;
  void retranslate() override;
  /// Exports the entries of the chosen period.
  bool exportTo(const std::filesystem::path& file, const CsvStyle& look = {});

 private:
  void read();
  void readMore();
  void showContent();
  void showEntry(const QString& id);
  void verify();
  void showVerdict();
  /// Returns "person T-30"; only the kind if there is no code.
  [[nodiscard]] QString objectText(const AuditEntry& entry) const;
  void askExport();
  /// Returns the chosen period, without a limit.
  [[nodiscard]] AuditFilter chosenTime() const;

  std::vector<AuditEntry> entries_;
  std::int64_t most_;     // maximum number of entries to read
  std::int64_t all_ = 0;  // number of entries in the chosen period
  std::map<std::string, std::string> logins_;
  std::map<std::string, std::string> subjects_;        // codes by object ids
  std::optional<std::vector<AuditFinding>> findings_;  // empty: not checked yet
  PageHeading* heading_;
  QPushButton* verify_;
  QPushButton* heads_;
  QLabel* verdict_;
  QComboBox* days_;
  QDateEdit* from_;
  QDateEdit* to_;
  QPushButton* export_ = nullptr;
  QToolButton* more_;
  DataTable* table_;
  QPlainTextEdit* entry_;
};

}  // namespace torsio::gui
