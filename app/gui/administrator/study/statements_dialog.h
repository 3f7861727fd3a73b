// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include <QDialog>

#include "assessment/domain/study/study_statement.h"

class QPlainTextEdit;

namespace torsio::gui {

/// Edits what a study says about itself, one field for each item. GUI thread.
class StatementsDialog : public QDialog {
  Q_OBJECT

 public:
  /// `cohort`: its name; `mayChange`: whether the fields can be edited.
  StatementsDialog(const QString& cohort, const StudyStatements& statements, bool mayChange, QWidget* parent);

  /// Returns the fields' contents without blanks around them; empty ones are absent.
  [[nodiscard]] StudyStatements statements() const;

 private:
  std::map<StudyItem, QPlainTextEdit*> fields_;
};

}  // namespace torsio::gui
