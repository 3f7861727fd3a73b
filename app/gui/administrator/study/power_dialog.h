// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QSpinBox;

namespace torsio::gui {

/// Sample size calculation of a study, and the power of a given number (torsio power). GUI thread.
class PowerDialog : public QDialog {
  Q_OBJECT

 public:
  explicit PowerDialog(QWidget* parent);

 private:
  void showAnswer();
  void showAgreement();

  QComboBox* design_;
  QSpinBox* groups_;
  QDoubleSpinBox* effect_;
  QDoubleSpinBox* power_;
  QDoubleSpinBox* alpha_;
  QDoubleSpinBox* correlation_;
  QDoubleSpinBox* icc_;
  QDoubleSpinBox* width_;
  QSpinBox* raters_;
  QSpinBox* atHand_;
  QFormLayout* form_;
  QLabel* needed_;
  QLabel* shown_;
};

}  // namespace torsio::gui
