// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <QDialog>
#include <QString>

#include "app/outputs/report/cell_trace.h"

class QTreeWidget;

namespace torsio::gui {

class DataTable;
class ShellContext;

/// All numbers of a report; traces the chosen one step by step to marks, criteria, recording and program
/// version. GUI thread.
class TraceDialog : public QDialog {
  Q_OBJECT

 public:
  /// `inputs`: the report's data.
  TraceDialog(ShellContext& shell, const CohortId& cohortId, std::shared_ptr<const CohortInputs> inputs,
              QWidget* parent);

  /// Selects the number with this address and traces it.
  void follow(const QString& address);

 private:
  void fill();
  void start();
  void show(const TraceStep& step);

  ShellContext& shell_;
  CohortId cohortId_;
  std::shared_ptr<const CohortInputs> inputs_;
  QString wanted_;
  QString followed_;
  bool running_ = false;
  DataTable* numbers_;
  QTreeWidget* steps_;
};

}  // namespace torsio::gui
