// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <QDialog>

#include "assessment/domain/ids.h"

class QPushButton;

namespace torsio::gui {

class DataTable;
class ShellContext;

/// Protocol deviations of a cohort, newest first. They are immutable: errors get a correction, for all
/// selected ones at once.
class DeviationsDialog : public QDialog {
  Q_OBJECT

 public:
  DeviationsDialog(ShellContext& shell, const CohortId& cohortId, QWidget* parent);

 private:
  void read();
  void correct();

  ShellContext& shell_;
  CohortId cohortId_;
  DataTable* table_;
  QPushButton* correct_;
};

}  // namespace torsio::gui
