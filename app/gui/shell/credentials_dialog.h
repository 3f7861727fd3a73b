// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QString>

class QLineEdit;

namespace torsio::gui {

/// Asks for another user's name and password, for one action that needs special rights.
class CredentialsDialog : public QDialog {
  Q_OBJECT

 public:
  CredentialsDialog(const QString& title, const QString& why, QWidget* parent = nullptr);
  [[nodiscard]] QString login() const;
  [[nodiscard]] QString password() const;

 private:
  QLineEdit* login_;
  QLineEdit* password_;
};

}  // namespace torsio::gui
