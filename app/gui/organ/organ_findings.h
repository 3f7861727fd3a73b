// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <QWidget>

#include "sim/scene/organ_import.h"

class QLabel;
class QVBoxLayout;

namespace torsio::gui {

/// Findings about an organ: verdict, measurements, and each finding with code, location, value and remedy.
/// GUI thread.
class OrganFindings : public QWidget {
  Q_OBJECT

 public:
  explicit OrganFindings(QWidget* parent = nullptr);

  void show(const OrganImport& import);
  void retranslate();

 private:
  void fill();
  void fillVerdict(const OrganImport& import);
  void addFinding(const OrganFinding& finding);
  QLabel* addLine(const QString& text, bool quiet);

  std::optional<OrganImport> import_;
  QLabel* verdict_;
  QLabel* measures_;
  QVBoxLayout* lines_;
  std::vector<QWidget*> shown_;
};

}  // namespace torsio::gui
