// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/widgets/page_parts.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace torsio::gui {

class FieldChecks;
class ShellContext;

/// Settings of all stations of the centre: name, idle minutes before warning and lock, what raters must watch
/// and when they review a discrepancy, grading of mouse runs, two-person rules, and how long a password is
/// valid for signing. Needs the right to change settings.
class CentreSettingsCard : public Card {
  Q_OBJECT

 public:
  explicit CentreSettingsCard(ShellContext& shell, QWidget* parent = nullptr);

  /// Rereads the settings.
  void read();
  void retranslate();

 private:
  void keep();
  void keepTwoPeople();

  ShellContext& shell_;
  QLabel* nameLabel_;
  QLineEdit* name_;
  QLabel* warnLabel_ = nullptr;
  QSpinBox* warn_;
  QLabel* lockLabel_ = nullptr;
  QSpinBox* lock_;
  QCheckBox* mouse_;
  QCheckBox* sound_;
  QCheckBox* panel_;
  QCheckBox* two_;
  QCheckBox* cards_;
  QLabel* factorLabel_ = nullptr;
  QComboBox* factor_;
  QLabel* signLabel_ = nullptr;
  QSpinBox* sign_;
  QLabel* watchedLabel_ = nullptr;
  QDoubleSpinBox* watched_;
  QLabel* speedsLabel_ = nullptr;
  QLineEdit* speeds_;
  QLabel* apartLabel_ = nullptr;
  QDoubleSpinBox* apart_;
  QLabel* note_;
  QPushButton* learning_;
  QPushButton* keep_;
  FieldChecks* checks_;
};

}  // namespace torsio::gui
