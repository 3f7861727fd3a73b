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

/// Linked traces over one time axis with cursor, bookmarks and watched stretches: angle, torque and force of
/// a twist, for an untwisting also the organ's condition; each trace with its scale and value at the cursor,
/// and the exercise's target, tolerance and limits as bands and lines. Click or drag moves the cursor. Traces
/// are rendered once per size and theme; moving the cursor costs the same for seconds and hours. Describes
/// itself to screen readers. GUI thread.
class TraceView : public QWidget {
  Q_OBJECT

 public:
  explicit TraceView(QWidget* parent = nullptr);

  /// Shows traces, which must outlive their display; null: none.
  void setData(const TraceData* traces);
  void setTheme(const Theme& theme);
  void retranslate();
  void setPosition_us(std::int64_t position_us);
  void setBookmarks(std::vector<std::int64_t> times_us);
  /// Sets the stretches that count as watched, microseconds.
  void setWatched(std::vector<std::pair<std::int64_t, std::int64_t>> spans_us);

  /// Returns name and scale of each trace as displayed, from top to bottom.
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
    float low = 0.0F;  // from values to displayed unit
    float high = 1.0F;
    float factor = 1.0F;  // as text
    int decimals = 0;
    QString scale;                                  // horizontal line
    std::optional<float> limit{};                   // target band, with a line in the middle
    std::optional<std::pair<float, float>> band{};  // Reserves space for the texts beside the traces.
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
  int labels_ = 0;    // width of the texts at the left
  int readings_ = 0;  // and at the right
};

}  // namespace torsio::gui
