// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <QRectF>
#include <QString>
#include <QStringList>
#include <QWidget>

#include "app/gui/widgets/theme.h"
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

/// Angle, blood flow, ischaemic dose and, if the content has pressure, the pressure of an untwisting over the
/// tissue's time. Above them, a row of symbols for actions and one for mishaps, distinct in shape and place,
/// with a legend below; a tool tip lists the instants at the pointer. The accessible description says the
/// same.
class DetorsionPlot : public QWidget {
  Q_OBJECT

 public:
  explicit DetorsionPlot(QWidget* parent = nullptr);

  void setStory(const DetorsionStory& story);
  void setTheme(const Theme& theme);
  void retranslate();
  [[nodiscard]] QSize sizeHint() const override { return {640, 400}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, 330}; }

  /// Names an instant in the user's language.
  [[nodiscard]] static QString momentName(DetorsionMoment moment);
  /// Returns the letter or symbol of an instant.
  [[nodiscard]] static QString momentSign(DetorsionMoment moment);
  /// Returns the tool tip at `x`: the instants within a few pixels, one per line; empty: none.
  [[nodiscard]] QString tipAt(double x) const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

 private:
  struct Lane {
    QRectF area;
    double low = 0.0;
    double middle = 0.5;
    double high = 1.0;
  };
  [[nodiscard]] bool presses() const;
  [[nodiscard]] int lanes() const;
  [[nodiscard]] double signsBottom() const;
  [[nodiscard]] Lane lane(int number, double low, double high) const;
  /// "gas out at 12.3 s (0:12 h of the tissue)".
  [[nodiscard]] QString momentText(const DetorsionStory::Event& event) const;
  [[nodiscard]] double xOf(double time_s) const;
  void drawLane(QPainter& painter, const Lane& lane, const QString& name, const std::vector<double>& values,
                double scale, std::optional<double> limit) const;
  void drawTime(QPainter& painter, double bottom) const;
  void drawEvents(QPainter& painter, double bottom) const;
  void drawSigns(QPainter& painter, bool mishaps) const;
  void drawLegend(QPainter& painter, const std::vector<DetorsionMoment>& told, double top) const;
  [[nodiscard]] QColor signColour(DetorsionMoment moment) const;

  const Theme* theme_;
  DetorsionStory story_;
};

}  // namespace torsio::gui
