// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/physician/trace_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>

#include "app/gui/physician/review_labels.h"
#include "sim/base/angle.h"

namespace torsio::gui {

namespace {

constexpr int kLaneGap = 6;
constexpr int kWatchedHeight = 4;
constexpr std::size_t kMostStretches = 65'536;  // a dozen for each pixel of the widest screen
constexpr std::int64_t kTickSteps_us[] = {1'000'000,  2'000'000,   5'000'000,   10'000'000,  30'000'000,
                                          60'000'000, 120'000'000, 300'000'000, 600'000'000, 1'800'000'000};

}  // namespace

TraceCollector::TraceCollector(std::int64_t samples)
    : perStretch_((static_cast<std::size_t>(std::max<std::int64_t>(samples, 0)) + kMostStretches - 1) /
                  kMostStretches) {
  perStretch_ = std::max<std::size_t>(perStretch_, 1);
}

void TraceCollector::add(std::span<const Sample> samples) {
  for (const Sample& sample : samples) {
    if (!begun_) {
      begin_us_ = sample.device.time_us;
    }
    begun_ = true;
    const std::array<float, 3> now{static_cast<float>(degrees(sample.response.angle_rad)),
                                   static_cast<float>(sample.response.torque_Nm),
                                   static_cast<float>(norm(sample.force_N))};
    data_.duration_us = sample.device.time_us - begin_us_;
    if (inStretch_ == 0) {
      data_.times_us.push_back(data_.duration_us);
    }
    for (std::size_t lane = 0; lane < now.size(); ++lane) {
      std::vector<float>& values = values_[lane];
      if (inStretch_ == 0) {
        values.insert(values.end(), 2, now[lane]);
      } else {
        values[values.size() - 2] = std::min(values[values.size() - 2], now[lane]);
        values.back() = std::max(values.back(), now[lane]);
      }
    }
    inStretch_ = (inStretch_ + 1) % perStretch_;
  }
}

TraceData TraceCollector::finish() {
  data_.angle_deg = RangePyramid(std::move(values_[0]));
  data_.torque_Nm = RangePyramid(std::move(values_[1]));
  data_.force_N = RangePyramid(std::move(values_[2]));
  return std::move(data_);
}

TraceView::TraceView(QWidget* parent) : QWidget(parent), theme_(&theme(ThemeKind::kLight)) {
  setCursor(Qt::PointingHandCursor);
  setFocusPolicy(Qt::NoFocus);  // the keys of the page move it; nothing here needs a focus of its own
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
}

void TraceView::setData(const TraceData* traces) {
  data_ = traces;
  position_us_ = 0;
  bookmarks_us_.clear();
  watched_us_.clear();
  traces_ = QPixmap();
  describe();
  update();
}

void TraceView::setTheme(const Theme& theme) {
  theme_ = &theme;
  traces_ = QPixmap();
  update();
}

void TraceView::retranslate() {
  setAccessibleName(tr("Traces of angle, torque and force"));
  traces_ = QPixmap();
  describe();
  update();
}

void TraceView::setPosition_us(std::int64_t position_us) {
  if (position_us == position_us_) {
    return;
  }
  const int before = xOf(position_us_);
  position_us_ = position_us;
  if (xOf(position_us_) != before) {
    update();
  }
}

void TraceView::setBookmarks(std::vector<std::int64_t> times_us) {
  bookmarks_us_ = std::move(times_us);
  describe();
  update();
}

void TraceView::setWatched(std::vector<std::pair<std::int64_t, std::int64_t>> spans_us) {
  watched_us_ = std::move(spans_us);
  update(0, height() - fontMetrics().height() - 3 * kWatchedHeight, width(), height());
}

QSize TraceView::sizeHint() const {
  return {480, 12 * fontMetrics().height()};
}

QSize TraceView::minimumSizeHint() const {
  return {240, 9 * fontMetrics().height()};
}

std::int64_t TraceView::duration_us() const noexcept {
  return data_ == nullptr ? 0 : data_->duration_us;
}

QRect TraceView::plot() const {
  const int labels = fontMetrics().horizontalAdvance(QStringLiteral("-0.000 N m ")) + kSpace;
  const int axis = fontMetrics().height() + kWatchedHeight + kSpace;
  return rect().adjusted(labels, kSpace / 2, -kSpace, -axis);
}

int TraceView::xOf(std::int64_t time_us) const {
  const QRect area = plot();
  const std::int64_t whole = std::max<std::int64_t>(duration_us(), 1);
  return area.left() + static_cast<int>(time_us * (area.width() - 1) / whole);
}

std::size_t TraceView::indexAt(std::int64_t time_us) const {
  const auto found = std::lower_bound(data_->times_us.begin(), data_->times_us.end(), time_us);
  return static_cast<std::size_t>(found - data_->times_us.begin());
}

std::vector<TraceView::Lane> TraceView::lanes() const {
  return {{tr("Angle"), QStringLiteral("\u00b0"), &data_->angle_deg, theme_->accent},
          {tr("Torque"), QStringLiteral("N m"), &data_->torque_Nm, theme_->good},
          {tr("Force"), QStringLiteral("N"), &data_->force_N, theme_->caution}};
}

void TraceView::drawTraces() {
  const qreal ratio = devicePixelRatioF();
  traces_ = QPixmap((QSizeF(size()) * ratio).toSize());
  traces_.setDevicePixelRatio(ratio);
  traces_.fill(theme_->window);
  QPainter painter(&traces_);
  painter.setFont(font());
  const QRect area = plot();
  if (data_ == nullptr || data_->times_us.empty()) {
    return;
  }
  const std::vector<Lane> all = lanes();
  const int height =
      (area.height() - kLaneGap * (static_cast<int>(all.size()) - 1)) / static_cast<int>(all.size());
  int top = area.top();
  for (const Lane& lane : all) {
    drawLane(painter, lane, {area.left(), top, area.width(), height});
    top += height + kLaneGap;
  }
  drawAxis(painter);
}

void TraceView::drawLane(QPainter& painter, const Lane& lane, const QRect& area) const {
  RangePyramid::Range whole = lane.values->whole();
  whole.low = std::min(whole.low, 0.0F);
  whole.high = std::max(whole.high, whole.low + 1e-3F);
  const auto yOf = [&](float value) {
    const float share = (value - whole.low) / (whole.high - whole.low);
    return area.bottom() - static_cast<int>(std::lround(share * static_cast<float>(area.height() - 3))) - 1;
  };
  painter.fillRect(area, theme_->surface);
  painter.setPen(theme_->line);
  painter.drawLine(area.left(), yOf(0.0F), area.right(), yOf(0.0F));
  painter.setPen(lane.colour);
  std::size_t first = 0;
  for (int x = 0; x < area.width(); ++x) {
    const std::int64_t until_us = duration_us() * (x + 1) / area.width();
    const std::size_t last = std::min(std::max(indexAt(until_us), first + 1), data_->times_us.size());
    if (first >= last) {
      break;
    }
    // One stretch of overlap joins the columns.
    const RangePyramid::Range range = lane.values->range(2 * (first > 0 ? first - 1 : 0), 2 * last);
    painter.drawLine(area.left() + x, yOf(range.low), area.left() + x, yOf(range.high));
    first = last;
  }
  const int labelWidth = area.left() - kSpace;
  painter.setPen(theme_->text);
  painter.drawText(QRect(0, area.top(), labelWidth, area.height() / 2), Qt::AlignLeft | Qt::AlignBottom,
                   lane.name);
  painter.setPen(theme_->quietText);
  // The direction of a twist is a sign: what is named is the end that lies farther from zero.
  const double peak = static_cast<double>(-whole.low > whole.high ? whole.low : whole.high);
  const int decimals = std::abs(peak) >= 10.0 ? 0 : std::abs(peak) >= 1.0 ? 1 : 2;
  painter.drawText(QRect(0, area.center().y(), labelWidth + kSpace, area.height() / 2),
                   Qt::AlignLeft | Qt::AlignTop,
                   QStringLiteral("%1 %2").arg(QLocale().toString(peak, 'f', decimals), lane.unit));
}

void TraceView::drawAxis(QPainter& painter) const {
  const QRect area = plot();
  const int width = fontMetrics().horizontalAdvance(QStringLiteral("00:00")) + 2 * kSpace;
  std::int64_t step_us = kTickSteps_us[std::size(kTickSteps_us) - 1];
  for (const std::int64_t candidate : kTickSteps_us) {
    if (xOf(candidate) - area.left() < width) {
      continue;
    }
    step_us = candidate;
    break;
  }
  painter.setPen(theme_->quietText);
  const int top = area.bottom() + kWatchedHeight + kSpace / 2;
  for (std::int64_t time_us = 0; time_us <= duration_us(); time_us += step_us) {
    const int x = xOf(time_us);
    const QString text = clockTime(time_us);
    const int half = fontMetrics().horizontalAdvance(text) / 2;
    const int left = std::clamp(x - half, area.left(), std::max(area.left(), area.right() - 2 * half));
    painter.drawText(left, top + fontMetrics().ascent(), text);
  }
}

void TraceView::paintEvent(QPaintEvent*) {
  if (traces_.isNull()) {
    drawTraces();
  }
  QPainter painter(this);
  painter.drawPixmap(0, 0, traces_);
  const QRect area = plot();
  painter.fillRect(QRect(area.left(), area.bottom() + 2, area.width(), kWatchedHeight), theme_->track);
  for (const auto& [from, to] : watched_us_) {
    const int left = xOf(from);
    painter.fillRect(QRect(left, area.bottom() + 2, std::max(1, xOf(to) - left), kWatchedHeight),
                     theme_->good);
  }
  painter.setRenderHint(QPainter::Antialiasing);
  for (const std::int64_t time_us : bookmarks_us_) {
    const double x = xOf(time_us) + 0.5;
    painter.setPen(QPen(theme_->text, 1.0, Qt::DotLine));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme_->text);
    painter.drawPolygon(
        QPolygonF({{x - 5, area.top() - 3.0}, {x + 5, area.top() - 3.0}, {x, area.top() + 5.0}}));
  }
  if (data_ == nullptr) {
    return;
  }
  const double x = xOf(position_us_) + 0.5;
  painter.setPen(QPen(theme_->text, 2.0));
  painter.drawLine(QPointF(x, area.top() - 2), QPointF(x, area.bottom() + kWatchedHeight + 2));
}

void TraceView::resizeEvent(QResizeEvent* event) {
  traces_ = QPixmap();
  QWidget::resizeEvent(event);
}

void TraceView::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) {
    seek(event->position().toPoint().x());
  }
}

void TraceView::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) != 0) {
    seek(event->position().toPoint().x());
  }
}

void TraceView::seek(int x) {
  if (data_ == nullptr) {
    return;
  }
  const QRect area = plot();
  const std::int64_t along = std::clamp(x - area.left(), 0, area.width() - 1);
  Q_EMIT soughtTo(along * duration_us() / std::max(1, area.width() - 1));
}

void TraceView::describe() {
  if (data_ == nullptr || data_->times_us.empty()) {
    setAccessibleDescription(tr("Nothing is loaded"));
    return;
  }
  const QLocale locale;
  const auto largest = [&locale](const RangePyramid& values, int decimals) {
    const RangePyramid::Range whole = values.whole();
    return locale.toString(static_cast<double>(std::max(-whole.low, whole.high)), 'f', decimals);
  };
  setAccessibleDescription(
      tr("%1 long; greatest angle %2 degrees, torque %3 newton metres, force %4 newtons; bookmarks: %5")
          .arg(clockTime(duration_us()), largest(data_->angle_deg, 0), largest(data_->torque_Nm, 2),
               largest(data_->force_N, 1), locale.toString(static_cast<qlonglong>(bookmarks_us_.size()))));
}

}  // namespace torsio::gui
