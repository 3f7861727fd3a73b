// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

#include "app/services/access/access_service.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace torsio::gui {

/// Sets one's own new password: forced after the first sign-in and after a reset, or chosen in the user menu.
/// Requires length; explains a refusal while typing.
class PasswordPanel : public QWidget {
  Q_OBJECT

 public:
  explicit PasswordPanel(QWidget* parent = nullptr);

  /// `oldPassword`: known after a sign-in that forces the change; otherwise empty, and asked for.
  /// `asksCode`: the account has a second factor.
  void begin(const QString& login, const QString& oldPassword, bool forced, bool asksCode);
  void say(const QString& sentence);
  void setWorking(bool working);

 Q_SIGNALS:
  void chosen(const torsio::PasswordChange& change);
  void givenUp();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void check();
  void goOn();  // focuses the first empty field, or submits
  void submit();
  void retranslate();

  QString login_;
  QString known_;
  bool forced_ = true;
  bool working_ = false;
  QLabel* heading_;
  QLabel* why_;
  QLabel* oldLabel_;
  QLabel* newLabel_;
  QLabel* againLabel_;
  QLabel* codeLabel_;
  QLineEdit* old_;
  QLineEdit* new_;
  QLineEdit* again_;
  QLineEdit* code_;
  QLabel* answer_;
  QPushButton* save_;
  QPushButton* back_;
};

}  // namespace torsio::gui
