// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/base/page.h"
#include "app/services/training/debrief.h"
#include "assessment/domain/ids.h"

class QBoxLayout;
class QCheckBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace torsio::gui {

class StationDesk;

class AskCard;
class Card;
class DebriefPlot;
class DebriefReplay;
class DetorsionCard;
class FoldedText;
class PageHeading;

/// Feedback right after a run: all targets, two strengths, two weaknesses with the seconds to look at, the
/// trace, the expert's curve.
class DebriefPage : public Page {
  Q_OBJECT

 public:
  /// `desk` must outlive the page.
  DebriefPage(ShellContext& shell, StationDesk& desk, QWidget* parent = nullptr);

  /// `argument`: id of the trial; default: the latest.
  void enter(const QVariant& argument) override;
  void retranslate() override;
  void applyTheme(const Theme& theme) override;
  [[nodiscard]] const Debrief& debrief() const noexcept { return debrief_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  StationDesk& desk_;

  void readQuestions();
  void showBookmark(double at_s);
  void compute(const TrialId& trialId);
  /// Adds the run to the session's story, with a picture if it contains the best twist.
  void tellStory();
  void connectParts();
  void fill();
  void fillNotes();
  /// Fills the card of a tracker's recording on the real arm.
  void fillRealArm();
  /// Arranges the 3D view beside its trace, or above it if the page is too narrow.
  void arrangeLooks();
  void fillTexts(bool any);
  void addAdvice(QVBoxLayout* column, const Text& advice);
  void addLook(QVBoxLayout* column, const Seconds& when);
  void addFinding(QVBoxLayout* column, const DebriefFinding& finding);
  void addCheck(const TargetCheck& check, const std::optional<MissedTarget>& missed);
  void seek(double at_s);
  void setMoment(double at_s);
  void addBookmarkAt(double at_s);

  Debrief debrief_;
  bool computing_ = false;
  bool haveReplay_ = false;
  const Theme* theme_;
  PageHeading* heading_;
  QLabel* verdict_;
  QLabel* competence_;
  FoldedText* rates_;
  Card* targets_;
  QVBoxLayout* checks_;
  Card* good_;
  QVBoxLayout* strengths_;
  Card* better_;
  QVBoxLayout* weaknesses_;
  Card* trace_;
  DetorsionCard* untwisting_;
  QBoxLayout* looks_;  // 3D view and trace
  Card* inThree_;      // 3D view of the run
  DebriefReplay* replay_;
  DebriefPlot* plot_;
  AskCard* ask_;
  QCheckBox* expert_;
  QPushButton* whole_;
  QPushButton* bookmark_;
  QPushButton* again_;
  QPushButton* trend_;
  QPushButton* next_;
  double moment_s_ = 0.0;  ///< position of replay and plot, used for questions and bookmarks
};

}  // namespace torsio::gui
