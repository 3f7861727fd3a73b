// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include <QWidget>

#include "app/services/study/rubric_service.h"
#include "assessment/domain/rating/rubric.h"

class QBoxLayout;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace torsio::gui {

class OrderedList;

/// The fields of a scale: from, to, step.
class ScaleFields : public QWidget {
  Q_OBJECT

 public:
  /// `name`: prefix of the object names of its fields: "row" gives "row.from", "row.to", "row.step".
  explicit ScaleFields(const QString& name, QWidget* parent = nullptr);

  void setScale(const ScoreScale& scale);
  /// Returns the input, which may be an invalid scale (see validateScale).
  [[nodiscard]] ScoreScale scale() const;
  void setReadOnly(bool readOnly);
  void retranslate();

 Q_SIGNALS:
  void edited();

 private:
  QDoubleSpinBox* from_;
  QDoubleSpinBox* to_;
  QComboBox* step_;
  QLabel* fromLabel_;
  QLabel* toLabel_;
  QLabel* stepLabel_;
};

/// Ordered criteria of a scoring sheet, each with name, scale, weight and anchors, and the scale of the
/// overall mark. GUI thread.
class RubricForm : public QWidget {
  Q_OBJECT

 public:
  explicit RubricForm(QWidget* parent = nullptr);

  void setRevision(const RubricRevision& revision);
  [[nodiscard]] const RubricRevision& revision() const noexcept { return revision_; }
  void setReadOnly(bool readOnly);
  /// Shows the errors beside the fields. Returns the errors of other criteria.
  std::vector<RubricProblem> showProblems();

 Q_SIGNALS:
  void edited();
  /// Another criterion is now shown.
  void shown();

 private:
  QWidget* rowForm();
  void addHint(QBoxLayout* column, RubricField field);
  void showLines(int row);
  void showRow();
  void showAnchors(const RubricLine& line);
  void takeRow();
  void addRow();
  void addAnchor();
  void removeAnchor();

  RubricRevision revision_;
  bool readOnly_ = false;
  bool filling_ = false;
  OrderedList* rows_;
  QLineEdit* label_;
  ScaleFields* scale_;
  QDoubleSpinBox* weight_;
  QTableWidget* anchors_;
  QPushButton* addAnchor_;
  QPushButton* removeAnchor_;
  ScaleFields* overall_;
  std::vector<std::pair<RubricField, QLabel*>> hints_;
};

}  // namespace torsio::gui
