// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QDialog>

#include "app/connectors/mail/mailing.h"
#include "app/services/study/open_sheets.h"
#include "assessment/domain/ids.h"
#include "sim/core/text.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace torsio::gui {

class DataTable;
class ShellContext;

/// Overdue sheets by rater, and reminders to the selected raters through the centre's mail server.
class RemindDialog : public QDialog {
  Q_OBJECT

 public:
  RemindDialog(ShellContext& shell, const CohortId& cohortId, QWidget* parent);

 private:
  void read();
  void showButtons();
  void askServer();
  void send();
  /// Returns the messages for the selected raters with an address.
  [[nodiscard]] std::vector<MailedReminder> messages() const;
  void showRefusals(const std::vector<MailedReminder>& sent, const std::vector<Text>& refusals);

  ShellContext& shell_;
  CohortId cohortId_;
  std::vector<Reminder> owed_;
  std::optional<MailSettings> settings_;
  DataTable* table_;
  QLabel* server_;
  QLabel* passwordLabel_ = nullptr;
  QLineEdit* password_;
  QPushButton* set_;
  QPushButton* copy_;
  QPushButton* send_;
};

/// Asks for the mail server; an empty name removes it. Object names of fields: "mailHost", "mailPort",
/// "mailEncryption", "mailUser" and "mailFrom". Empty: cancelled.
[[nodiscard]] std::optional<MailSettings> askMailServer(QWidget* parent,
                                                        const std::optional<MailSettings>& before);

}  // namespace torsio::gui
