// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <QDialog>

#include "assessment/domain/ids.h"

class QPushButton;

namespace torsio::gui {

class DataTable;
class ShellContext;

/// The deviations from the protocol that were noted in a cohort, newest first. They are sealed: what was
/// entered in error gets a correction beside it, for all that are chosen at once.
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
