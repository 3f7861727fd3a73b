// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <QDialog>

#include "app/services/study/paper_sheets.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/sheet_check.h"

class QCheckBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QScrollArea;

namespace torsio::gui {

class DataTable;
class ShellContext;

/// Marks from paper sheets: two people enter each sheet blindly, and it counts if both entries agree.
class PaperDialog : public QDialog {
  Q_OBJECT

 public:
  PaperDialog(ShellContext& shell, CohortId cohortId, QWidget* parent);

 private:
  /// The entry of one row.
  struct Field {
    std::string code;
    ScoreScale scale;
    QDoubleSpinBox* mark;  // one step below the scale means empty
    QCheckBox* none;
    QLineEdit* reason;
  };

  void read();
  void showForm();
  void addField(int row, const QString& label, const std::string& code, const ScoreScale& scale,
                const SheetAnswer& typed, bool differs);
  void keep();
  [[nodiscard]] QString stateText(const PaperCase& one) const;
  [[nodiscard]] Sheet typed() const;

  ShellContext& shell_;
  CohortId cohortId_;
  std::vector<PaperCase> cases_;
  std::optional<PaperForm> form_;
  AssignmentId chosen_;
  std::vector<Field> fields_;
  DataTable* table_;
  QLabel* title_;
  QScrollArea* scroll_;
  QLabel* commentLabel_ = nullptr;
  QLineEdit* comment_;
  QPushButton* keep_;
};

}  // namespace torsio::gui
