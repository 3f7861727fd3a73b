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

/// Whether other programs (Slicer) may follow this station's instrument by OpenIGTLink, where, and whether
/// one does now. Offers it while it is open, so that the other program can be tried.
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
  std::shared_ptr<InstrumentOutlet> outlet_;  // null: nothing is offered
  QCheckBox* on_;
  QComboBox* who_;
  QSpinBox* port_;
  QLabel* caution_;
  QLabel* state_;
};

}  // namespace torsio::gui
