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

/// The debrief of an untwisting: time line, where the seconds went, and the measures, in plain sentences.
class DetorsionCard : public QWidget {
  Q_OBJECT

 public:
  explicit DetorsionCard(QWidget* parent = nullptr);

  void setStory(const DetorsionStory& story);
  void setTheme(const Theme& theme);
  void retranslate();

  /// Says where the seconds went, longest first, in the user's language; what took none is left out.
  [[nodiscard]] static QStringList secondsText(const DetorsionStory& story);
  /// Says what the numbers come to, in sentences.
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
