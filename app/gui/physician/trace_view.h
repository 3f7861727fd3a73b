// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <QPixmap>
#include <QString>
#include <QStringList>
#include <QWidget>

#include "app/gui/physician/trace_data.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

/// The linked traces over one time axis with cursor, bookmarks and the stretches that have been watched: of a
/// twist angle, torque and force; of an untwisting also how the organ fares, each trace with its scale and
/// its value at the cursor; target, tolerance and limits of the exercise as bands and lines. A click or drag
/// moves the cursor. The traces are drawn once a size and theme; moving the cursor costs the same for seconds
/// and for hours. Says the same in words to screen readers.
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

  /// Returns name and scale of each trace, from top to bottom, as they are written beside it.
  [[nodiscard]] QStringList laneTexts() const;
  /// Returns the value of each trace at the cursor, with its unit.
  [[nodiscard]] QStringList readings() const;

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
    float low = 0.0F;  // ends of the scale
    float high = 1.0F;
    float factor = 1.0F;  // of the values, for the unit in which they are told
    int decimals = 0;
    QString scale;                                  // in words
    std::optional<float> limit{};                   // a line across
    std::optional<std::pair<float, float>> band{};  // what is aimed at, with a line in the middle
  };
  [[nodiscard]] std::int64_t duration_us() const noexcept;
  [[nodiscard]] QRect plot() const;
  [[nodiscard]] int xOf(std::int64_t time_us) const;
  [[nodiscard]] std::size_t indexAt(std::int64_t time_us) const;
  [[nodiscard]] bool untwisting() const noexcept { return data_ != nullptr && data_->untwisting(); }
  [[nodiscard]] int lineHeights(int ofATwist, int ofALane) const;
  /// Makes room beside the traces for what is written there.
  void layOut();
  [[nodiscard]] QRect laneArea(std::size_t number) const;
  [[nodiscard]] std::vector<Lane> lanes() const;
  [[nodiscard]] Lane lane(TraceKind kind) const;
  void mark(TraceKind kind, Lane& made) const;
  void tellScale(TraceKind kind, Lane& made) const;
  void drawReadings(QPainter& painter) const;
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
  int labels_ = 0;    // width of what stands left of the traces
  int readings_ = 0;  // and right of them
};

}  // namespace torsio::gui
