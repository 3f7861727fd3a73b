// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/widgets/card.h"

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace torsio::gui {

class FieldChecks;
class ShellContext;

/// What holds at every station of the centre: its name, after how many minutes an empty place warns and
/// locks, what raters must watch and when they review a discrepancy, whether runs with the mouse are graded,
/// what needs two people, and for how long a password signs. For those who may change settings.
class StationSettingsCard : public Card {
  Q_OBJECT

 public:
  explicit StationSettingsCard(ShellContext& shell, QWidget* parent = nullptr);

  /// Reads the settings anew.
  void read();
  void retranslate();

 private:
  void keep();
  void keepTwoPeople();

  ShellContext& shell_;
  QLabel* nameLabel_;
  QLineEdit* name_;
  QLabel* warnLabel_;
  QSpinBox* warn_;
  QLabel* lockLabel_;
  QSpinBox* lock_;
  QCheckBox* mouse_;
  QCheckBox* sound_;
  QCheckBox* two_;
  QCheckBox* cards_;
  QLabel* signLabel_;
  QSpinBox* sign_;
  QLabel* watchedLabel_;
  QDoubleSpinBox* watched_;
  QLabel* speedsLabel_;
  QLineEdit* speeds_;
  QLabel* apartLabel_;
  QDoubleSpinBox* apart_;
  QLabel* note_;
  QPushButton* learning_;
  QPushButton* keep_;
  FieldChecks* checks_;
};

}  // namespace torsio::gui
