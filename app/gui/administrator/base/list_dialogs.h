// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <QDialog>

#include "sim/base/ids.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace torsio::gui {

class DataTable;
class ShellContext;

/// Every decision of one person about what may be kept and used, and what was signed on paper since.
class ConsentDialog : public QDialog {
  Q_OBJECT

 public:
  /// `code`: pseudonym of the person, for the title.
  ConsentDialog(ShellContext& shell, PersonId personId, const QString& code, QWidget* parent = nullptr);

 private:
  void read();
  void record(bool granted);
  [[nodiscard]] QString titleOf(const std::string& purpose) const;

  ShellContext& shell_;
  PersonId personId_;
  QComboBox* purpose_;
  QPushButton* granted_;
  QPushButton* withdrawn_;
  DataTable* decisions_;
};

/// Shows the deviations from the protocol that were noted in a cohort, newest first. Throws Error.
void showDeviations(ShellContext& shell, const CohortId& cohortId, QWidget* parent);

}  // namespace torsio::gui
