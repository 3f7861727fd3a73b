// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <QRectF>
#include <QWidget>

#include "app/gui/widgets/theme.h"
#include "app/training/detorsion_story.h"

namespace torsio::gui {

/// Angle, blood flow and ischaemic dose of an untwisting over the tissue's time, with what was done as marks
/// above. Says the same in its accessible description.
class DetorsionPlot : public QWidget {
  Q_OBJECT

 public:
  explicit DetorsionPlot(QWidget* parent = nullptr);

  void setStory(const DetorsionStory& story);
  void setTheme(const Theme& theme);
  void retranslate();
  [[nodiscard]] QSize sizeHint() const override { return {640, 380}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, 300}; }

  /// Names an instant in the user's language.
  [[nodiscard]] static QString momentName(DetorsionMoment moment);
  /// Returns one letter or sign that stands for an instant in the picture.
  [[nodiscard]] static QString momentSign(DetorsionMoment moment);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Lane {
    QRectF area;
    double low = 0.0;
    double high = 1.0;
  };
  [[nodiscard]] Lane lane(int number, double low, double high) const;
  [[nodiscard]] double xOf(double time_s) const;
  void drawLane(QPainter& painter, const Lane& lane, const QString& name, const std::vector<double>& values,
                double scale, std::optional<double> limit) const;
  void drawTime(QPainter& painter, double bottom) const;
  void drawEvents(QPainter& painter, double bottom) const;

  const Theme* theme_;
  DetorsionStory story_;
};

}  // namespace torsio::gui
