// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QWidget>

#include "app/services/organs/person_arm.h"

class QDoubleSpinBox;
class QFormLayout;
class QLabel;

namespace torsio::gui {

/// The measures of a person's wrist, hand and fingers, a field each; they begin with those of a man. GUI
/// thread.
class ArmForm : public QWidget {
  Q_OBJECT

 public:
  explicit ArmForm(QWidget* parent = nullptr);

  /// What the fields say.
  [[nodiscard]] PersonArm person() const;
  /// Back to a man's.
  void reset();
  void retranslate();

 private:
  struct Field {
    QDoubleSpinBox* box;
    QLabel* label;
    double man_mm;
  };
  /// The field gets `name` as its object name.
  void addLength(QFormLayout& form, const char* name, const PersonLength& range);

  std::vector<Field> fields_;
};

}  // namespace torsio::gui
