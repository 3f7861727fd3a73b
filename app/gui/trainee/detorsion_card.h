// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <QWidget>

#include "app/services/training/detorsion_story.h"

class QLabel;

namespace torsio::gui {

class Card;
class DetorsionPlot;
struct Theme;

/// The debrief of an untwisting: time line, time spent, and measures, in plain sentences.
class DetorsionCard : public QWidget {
  Q_OBJECT

 public:
  explicit DetorsionCard(QWidget* parent = nullptr);

  void setStory(const DetorsionStory& story);
  void setTheme(const Theme& theme);
  void retranslate();

  /// Returns how the time was spent, longest first, in the user's language, without activities that took
  /// none.
  [[nodiscard]] static QStringList secondsText(const DetorsionStory& story);
  /// Returns the conclusions in sentences.
  [[nodiscard]] static QStringList findings(const DetorsionStory& story);

 private:
  DetorsionStory story_;
  Card* line_;
  Card* spent_;
  Card* measures_;
  DetorsionPlot* plot_;
  QLabel* spentText_;
  QLabel* measuresText_;
};

}  // namespace torsio::gui
