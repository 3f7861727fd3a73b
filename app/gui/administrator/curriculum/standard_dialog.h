// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPlainTextEdit;

namespace torsio::gui {

/// Standard setting: calculates the cut score from a pasted table of judges or scores at once (like torsio
/// standard-setting). Stores nothing. GUI thread.
class StandardDialog : public QDialog {
  Q_OBJECT

 public:
  explicit StandardDialog(QWidget* parent);

 private:
  void showMethod();
  void showAnswer();
  void readAnswer();

  QComboBox* method_;
  QLabel* asks_;
  QPlainTextEdit* table_;
  QDoubleSpinBox* borderline_;
  QLabel* answer_;
  QFormLayout* form_;
};

}  // namespace torsio::gui
