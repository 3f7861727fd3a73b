// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QDialog>

#include "app/services/installation/installation_check.h"

namespace torsio::gui {

/// What was found on this computer, the worst first, each with its remedy; a report on it can be saved. GUI
/// thread.
class InstallationDialog : public QDialog {
  Q_OBJECT

 public:
  InstallationDialog(std::vector<InstallationCheck> checks, QWidget* parent);

 Q_SIGNALS:
  /// Somebody wants a report for support in this file.
  void reportWanted(const QString& file);

 private:
  void askForFile();
};

}  // namespace torsio::gui
