// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <QDialog>

class QCheckBox;
class QComboBox;
class QLabel;
class QSpinBox;

namespace torsio {
class InstrumentOutlet;
}

namespace torsio::gui {

class ShellContext;

/// Settings of the OpenIGTLink output of this station's instrument to other programs (Slicer), and its
/// connection state. Open for connections while the dialog is open, for a trial.
class InstrumentOutletDialog : public QDialog {
  Q_OBJECT

 public:
  InstrumentOutletDialog(ShellContext& shell, QWidget* parent);

 private:
  void build();
  void read();
  void keep();
  void showState();

  ShellContext& shell_;
  std::shared_ptr<InstrumentOutlet> outlet_;  // null: output is off
  QCheckBox* on_;
  QComboBox* who_;
  QSpinBox* port_;
  QLabel* caution_;
  QLabel* state_;
};

}  // namespace torsio::gui
