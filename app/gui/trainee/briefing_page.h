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

/// What is asked for, and an expert's run of the same pattern to watch.
class BriefingPage : public Page {
  Q_OBJECT

 public:
  /// `desk` outlives the page.
  BriefingPage(ShellContext& shell, StationDesk& desk, QWidget* parent = nullptr);
  ~BriefingPage() override;

  /// Of StationDesk::moduleId; with the argument "later" it waits for the next call.
  void enter(const QVariant& argument) override;
  [[nodiscard]] bool leave() override;
  void retranslate() override;
  void applyTheme(const Theme& theme) override;
  [[nodiscard]] ShellContext& context() const noexcept { return shell(); }
  [[nodiscard]] StationDesk& desk() const noexcept { return desk_; }

 private:
  StationDesk& desk_;

  /// What stands below the picture.
  QLayout* createBar();
  void showExpert();
  /// Says below the picture what the expert does at this moment, and plays as slowly as is wanted.
  void follow(const LiveState& state);
  void fill();

  ModuleStep step_;
  CompetenceVerdict competence_{};
  bool asked_ = false;   // the expert's run was asked for
  bool seen_ = false;    // and began to play, with a picture of the organ
  bool undone_ = false;  // the module undoes an organ that came twisted
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
