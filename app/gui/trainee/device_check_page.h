// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/base/page.h"
#include "app/services/devices/device_readiness.h"

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace torsio::gui {

class StationDesk;

class Card;
class PageHeading;

/// Checks the device before a run: green permits everything, amber only practice, red only the mouse.
class DeviceCheckPage : public Page {
  Q_OBJECT

 public:
  /// `desk` must outlive the page.
  DeviceCheckPage(ShellContext& shell, StationDesk& desk, QWidget* parent = nullptr);

  void enter(const QVariant& argument) override;
  void retranslate() override;
  void applyTheme(const Theme& theme) override;

 private:
  StationDesk& desk_;

  void check();
  void fill();
  void goOn(bool graded);
  /// Stores the result, and reports it to the board of the day.
  void found(const DeviceReadiness& readiness);

  const Theme* theme_;
  PageHeading* heading_;
  Card* card_;
  QVBoxLayout* findings_;
  QLabel* verdict_;
  QLabel* meaning_;
  QPushButton* again_;
  QPushButton* mouse_;
  QPushButton* practise_;
  QPushButton* goOn_;
  bool checking_ = false;
};

}  // namespace torsio::gui
