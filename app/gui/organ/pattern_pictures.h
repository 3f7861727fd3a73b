// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <QWidget>

#include "app/gui/base/scene_titles.h"
#include "app/gui/widgets/theme.h"
#include "app/outputs/charts/chart_style.h"
#include "sim/scene/organ_import.h"

class QVBoxLayout;

namespace torsio::gui {

/// Every pattern that was judged on an organ: whether it is offered, else why not, and pictures of the organ
/// at rest, half way and at the target, or as far as it stays whole. GUI thread.
class PatternPictures : public QWidget {
  Q_OBJECT

 public:
  explicit PatternPictures(std::filesystem::path assets, QWidget* parent = nullptr);

  /// Shows the patterns of an import that was asked for pictures; returns whether there are any.
  bool show(const OrganImport& import);
  void retranslate();
  void setTheme(const Theme& theme);

 private:
  void fill();
  void addPattern(const PatternJudgement& pattern);
  QWidget* pictureRow(const PatternJudgement& pattern);

  SceneTitles titles_;
  std::string anatomy_;
  std::vector<PatternJudgement> patterns_;
  std::shared_ptr<const TriangleMesh> drawn_;
  ChartStyle style_;
  QVBoxLayout* lines_;
  std::vector<QWidget*> shown_;
};

}  // namespace torsio::gui
