// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

class QLabel;
class QLineEdit;
class QPushButton;

namespace torsio::gui {

/// Covers a desk whose owner is away; the work behind is unchanged.
class LockPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LockPanel(QWidget* parent = nullptr);
  void begin(const QString& login);
  void say(const QString& sentence);
  void setWorking(bool working);

 Q_SIGNALS:
  void passwordGiven(const QString& password);
  void signOutWanted();

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void retranslate();
  QString login_;
  QLabel* heading_;
  QLabel* why_;
  QLabel* label_;
  QLineEdit* secret_;
  QLabel* answer_;
  QPushButton* unlock_;
  QPushButton* signOut_;
};

}  // namespace torsio::gui
