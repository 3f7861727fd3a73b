// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "app/gui/base/page.h"
#include "app/services/devices/device_check.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace torsio::gui {

class CentreSettingsCard;
class DataTable;
class PageHeading;

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
  QLabel* station_;  ///< name of this station
  QLabel* verdict_;
  DataTable* table_;
  CentreSettingsCard* settings_;
};

}  // namespace torsio::gui
