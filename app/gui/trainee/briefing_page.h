// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/base/page.h"
#include "app/services/training/next_steps.h"
#include "app/services/training/trend.h"

class QLabel;
class QLayout;
class QPushButton;

namespace torsio::gui {

class StationDesk;

class Card;
class LiveScene;

/// The task, with an expert's run of the same pattern to watch.
class BriefingPage : public Page {
  Q_OBJECT

 public:
  /// `desk` must outlive the page.
  BriefingPage(ShellContext& shell, StationDesk& desk, QWidget* parent = nullptr);
  ~BriefingPage() override;

  /// For StationDesk::moduleId; argument "later": waits for the next call.
  void enter(const QVariant& argument) override;
  [[nodiscard]] bool leave() override;
  void retranslate() override;
  void applyTheme(const Theme& theme) override;
  [[nodiscard]] ShellContext& context() const noexcept { return shell(); }
  [[nodiscard]] StationDesk& desk() const noexcept { return desk_; }

 private:
  StationDesk& desk_;

  /// Creates the controls below the picture.
  QLayout* createBar();
  void showExpert();
  /// Describes the expert's present action below the picture, and applies the slow-down.
  void follow(const LiveState& state);
  void fill();

  ModuleStep step_;
  CompetenceVerdict competence_{};
  bool asked_ = false;   // the expert's run was requested
  bool seen_ = false;    // the expert's run has started to play, with a picture of the organ
  bool undone_ = false;  // the module untwists an organ
  LiveScene* scene_;
  QLabel* title_;
  QLabel* task_;
  QLabel* goals_;
  QLabel* mode_;
  Card* what_;
  Card* how_;
  QLabel* hints_;
  Card* able_;
  QLabel* design_;
  QLabel* errors_;
  QLabel* caption_;
  QPushButton* slow_;
  QPushButton* again_;
  QPushButton* start_;
  QPushButton* back_;
};

}  // namespace torsio::gui
