// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QWidget>

#include "app/services/organs/person_arm.h"

class QDoubleSpinBox;
class QFormLayout;
class QLabel;

namespace torsio::gui {

/// Fields for the measurements of a person's wrist, hand and fingers; initially a man's. GUI thread.
class ArmForm : public QWidget {
  Q_OBJECT

 public:
  explicit ArmForm(QWidget* parent = nullptr);

  /// Returns the input.
  [[nodiscard]] PersonArm person() const;
  /// Resets to a man's measurements.
  void reset();
  void retranslate();

 private:
  struct Field {
    QDoubleSpinBox* box;
    QLabel* label;
    double man_mm;
  };
  /// `name`: object name of the field.
  void addLength(QFormLayout& form, const char* name, const PersonLength& range);

  std::vector<Field> fields_;
};

}  // namespace torsio::gui
