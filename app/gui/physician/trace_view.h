// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <QPixmap>
#include <QString>
#include <QWidget>

#include "app/gui/widgets/theme.h"
#include "app/review/range_pyramid.h"
#include "sim/base/live_types.h"

namespace torsio::gui {

/// Angle, torque and force of a recording, ready to be drawn at any width: for each stretch of time, lowest
/// and highest value one after the other. A short recording has one stretch a sample; a long one no more
/// stretches than any screen can show, so that forty minutes take as little room as one.
struct TraceData {
  RangePyramid angle_deg;
  RangePyramid torque_Nm;
  RangePyramid force_N;
  std::vector<std::int64_t> times_us;  ///< where each stretch begins, since the first sample
  std::int64_t duration_us = 0;
};

/// Makes traces while the samples go by. Any one thread.
class TraceCollector {
 public:
  /// `samples`: as many as will come, about.
  explicit TraceCollector(std::int64_t samples);
  /// The next ones, in order.
  void add(std::span<const Sample> samples);
  [[nodiscard]] TraceData finish();

 private:
  std::size_t perStretch_;
  std::size_t inStretch_ = 0;
  std::int64_t begin_us_ = 0;
  bool begun_ = false;
  std::array<std::vector<float>, 3> values_;  // angle, torque, force; low, high, low, high ...
  TraceData data_;
};

/// Three linked traces over one time axis with cursor, bookmarks and the stretches that have been watched. A
/// click or drag moves the cursor. The traces are drawn once a size and theme; moving the cursor costs the
/// same for seconds and for hours. Says the same in words to screen readers.
class TraceView : public QWidget {
  Q_OBJECT

 public:
  explicit TraceView(QWidget* parent = nullptr);

  /// Null: nothing to show. The data outlives its showing.
  void setData(const TraceData* traces);
  void setTheme(const Theme& theme);
  void retranslate();
  void setPosition_us(std::int64_t position_us);
  void setBookmarks(std::vector<std::int64_t> times_us);
  /// Stretches that count as watched, microseconds.
  void setWatched(std::vector<std::pair<std::int64_t, std::int64_t>> spans_us);

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 Q_SIGNALS:
  void soughtTo(qint64 position_us);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  struct Lane {
    QString name;
    QString unit;
    const RangePyramid* values = nullptr;
    QColor colour;
  };
  [[nodiscard]] std::int64_t duration_us() const noexcept;
  [[nodiscard]] QRect plot() const;
  [[nodiscard]] int xOf(std::int64_t time_us) const;
  [[nodiscard]] std::size_t indexAt(std::int64_t time_us) const;
  [[nodiscard]] std::vector<Lane> lanes() const;
  void drawTraces();
  void drawLane(QPainter& painter, const Lane& lane, const QRect& area) const;
  void drawAxis(QPainter& painter) const;
  void seek(int x);
  void describe();

  const TraceData* data_ = nullptr;
  const Theme* theme_;
  std::int64_t position_us_ = 0;
  std::vector<std::int64_t> bookmarks_us_;
  std::vector<std::pair<std::int64_t, std::int64_t>> watched_us_;
  QPixmap traces_;
};

}  // namespace torsio::gui
