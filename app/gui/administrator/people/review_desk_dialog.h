// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QDialog>

#include "app/gui/base/shell_context.h"
#include "app/services/serving/review_desk.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace torsio::gui {

/// Opens and closes the review desk for browsers on this machine (`torsio serve`). GUI thread.
class ReviewDeskDialog : public QDialog {
  Q_OBJECT

 public:
  ReviewDeskDialog(ShellContext& shell, DeskPlace place, QWidget* parent);

  /// Returns what opens a desk on this machine: the running program and a folder of this account.
  [[nodiscard]] static DeskPlace ownPlace();

 private:
  void build();
  void read();
  void showChoices();
  void openDesk();
  void closeDesk();
  /// Runs work in the background; then shows the new state, or the error.
  void act(const QString& title, std::function<void(SessionContext&)> work);
  void copyAddress();
  void chooseFile(QLineEdit* field, const QString& title);
  [[nodiscard]] DeskWish wish() const;

  ShellContext& shell_;
  DeskPlace place_;
  bool open_ = false;
  bool working_ = false;
  QLabel* state_;
  QWidget* openPart_;
  QComboBox* address_;
  QPushButton* copy_;
  QLabel* trust_;
  QWidget* choices_;
  QComboBox* reach_;
  QSpinBox* port_;
  QComboBox* certificate_;
  QWidget* files_;
  QLineEdit* certificateFile_;
  QLineEdit* keyFile_;
  QCheckBox* goesOn_;
  QLabel* said_;
  QPushButton* act_;
};

}  // namespace torsio::gui
