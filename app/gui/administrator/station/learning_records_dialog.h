// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "app/connectors/xapi/learning_records.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace torsio::gui {

class DataTable;
class ShellContext;

/// Settings of learning records: target, this station's key, waiting and rejected records. Needs the right to
/// change settings.
class LearningRecordsDialog : public QDialog {
  Q_OBJECT

 public:
  LearningRecordsDialog(ShellContext& shell, QWidget* parent);

 private:
  void build();
  void read();
  void showView(const LearningRecordsView& view);
  void keep();
  void keepKey();
  void sendNow();
  void retry();
  void drop();

  ShellContext& shell_;
  QCheckBox* on_;
  QLineEdit* endpoint_;
  QLineEdit* homePage_;
  QLineEdit* user_;
  QLineEdit* secret_;
  QLabel* key_;
  QLabel* state_;
  DataTable* dead_;
  QPushButton* send_;
  QPushButton* retry_;
  QPushButton* drop_;
};

}  // namespace torsio::gui
