// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QWidget>

#include "app/gui/widgets/theme.h"
#include "app/services/training/debrief.h"

namespace torsio::gui {

/// Angle and force of a run over time: target band, expert's curve at each grip, bookmarks, and a highlighted
/// range of seconds. Wheel or + and - zoom, dragging or arrows move; a double click requests a bookmark. The
/// accessible description says the same.
class DebriefPlot : public QWidget {
  Q_OBJECT

 public:
  explicit DebriefPlot(QWidget* parent = nullptr);

  void setDebrief(Debrief debrief);
  /// Adds a mark without changing the visible range.
  void addBookmark(const DebriefBookmark& mark);
  void setTheme(const Theme& theme);
  void setExpertVisible(bool visible);
  /// Moves the playhead, with the values at that moment.
  void setPosition(double at_s);
  /// Returns time, angle and force at the playhead as displayed.
  [[nodiscard]] QString reading() const;
  /// Shows this range with a margin.
  void show(const Seconds& when);
  void showAll();
  [[nodiscard]] const Seconds& range() const noexcept { return range_; }
  void retranslate();
  [[nodiscard]] QSize sizeHint() const override { return {640, 320}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, 220}; }

 Q_SIGNALS:
  void bookmarkWanted(double at_s);
  /// The user chose a moment of the run.
  void soughtTo(double at_s);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Lane {
    QRectF area;
    double low = 0.0;
    double high = 1.0;
  };
  [[nodiscard]] double xOf(double time_s) const;
  [[nodiscard]] double timeOf(double x) const;
  [[nodiscard]] static double yOf(const Lane& lane, double value);
  [[nodiscard]] Lane angleLane() const;
  [[nodiscard]] Lane forceLane() const;
  void drawCurve(QPainter& painter, const Lane& lane, const std::vector<double>& time_s,
                 const std::vector<double>& values, double scale, double offset_s) const;
  void drawAxes(QPainter& painter, const Lane& angle, const Lane& force) const;
  void zoom(double factor, double at_s);
  void move(double by_s);

  const Theme* theme_;
  Debrief debrief_;
  Seconds range_{0.0, 1.0};
  std::optional<Seconds> marked_;
  bool expertVisible_ = true;
  double dragFrom_s_ = 0.0;
  bool dragged_ = false;
  double position_s_ = 0.0;
};

}  // namespace torsio::gui
