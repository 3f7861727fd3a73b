// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <optional>

#include "app/gui/base/page.h"
#include "app/gui/widgets/page_parts.h"
#include "app/services/devices/device_check.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QDoubleSpinBox;
class QSpinBox;

namespace torsio::gui {

class DataTable;
class PageHeading;
class StationSettingsCard;

/// Checks whether this station's haptic device is fit for scored runs, and shows remedies.
class DevicesPage : public Page {
  Q_OBJECT

 public:
  explicit DevicesPage(ShellContext& shell);

  void enter(const QVariant& argument) override;
  void retranslate() override;

  void check();
  [[nodiscard]] const std::optional<DeviceCheckResult>& result() const noexcept { return result_; }

 private:
  void showContent();
  [[nodiscard]] DeviceChoice choice() const;
  void remember();

  std::optional<DeviceCheckResult> result_;
  PageHeading* heading_;
  QPushButton* check_;
  QLabel* driverLabel_ = nullptr;
  QComboBox* driver_;
  QLabel* nameLabel_;
  QLineEdit* name_;
  QCheckBox* force_;
  QPushButton* others_;
  QLabel* verdict_;
  DataTable* table_;
  StationSettingsCard* settings_;
};

class FieldChecks;
class ShellContext;

/// Settings of all stations of the centre: name, idle minutes before warning and lock, what raters must watch
/// and when they review a discrepancy, grading of mouse runs, two-person rules, and how long a password is
/// valid for signing. Needs the right to change settings.
class StationSettingsCard : public Card {
  Q_OBJECT

 public:
  explicit StationSettingsCard(ShellContext& shell, QWidget* parent = nullptr);

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
  QCheckBox* two_;
  QCheckBox* cards_;
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
