// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/simulator/film_strip.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QLocale>
#include <QPainter>

#include "app/gui/scene/scene_view.h"
#include "app/report/typeface.h"
#include "sim/base/angle.h"
#include "sim/record/sample_codec.h"

namespace torsio::gui {

namespace {

constexpr int kGap = 8;
constexpr int kFrameWidth = 480;
constexpr std::size_t kFramesInARow = 4;
constexpr double kStep_rad = std::numbers::pi / 6.0;
constexpr double kNear_rad = radians(0.5);  // a last step of half a degree shows nothing new

}  // namespace

QImage filmStrip(const std::vector<std::vector<StripFrame>>& rows) {
  if (rows.empty() || rows.front().empty() || rows.front().front().picture.isNull()) {
    return {};
  }
  const QSize first = rows.front().front().picture.size();
  const QSize cell(kFrameWidth, kFrameWidth * first.height() / first.width());
  QFont font = typeface();
  font.setPixelSize(18);
  const int caption = QFontMetrics(font).height() + kGap;
  const auto columns = static_cast<int>(rows.front().size());
  QImage strip(columns * (cell.width() + kGap) + kGap,
               static_cast<int>(rows.size()) * (cell.height() + caption + kGap) + kGap, QImage::Format_RGB32);
  strip.fill(Qt::white);
  QPainter painter(&strip);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.setFont(font);
  painter.setPen(Qt::black);
  int y = kGap;
  for (const std::vector<StripFrame>& row : rows) {
    int x = kGap;
    for (const StripFrame& frame : row) {
      painter.drawImage(QRect(QPoint(x, y), cell), frame.picture);
      painter.drawText(QRect(x, y + cell.height(), cell.width(), caption), Qt::AlignCenter, frame.caption);
      x += cell.width() + kGap;
    }
    y += cell.height() + caption + kGap;
  }
  return strip;
}

std::vector<std::vector<StripFrame>> stripRows(const std::vector<StripFrame>& frames) {
  std::vector<std::vector<StripFrame>> rows;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (i % kFramesInARow == 0) {
      rows.emplace_back();
    }
    rows.back().push_back(frames[i]);
  }
  return rows;
}

std::vector<double> stripAngles_rad(double last_rad) {
  std::vector<double> angles;
  const double size_rad = std::abs(last_rad);
  for (int step = 0; step * kStep_rad < size_rad - kNear_rad; ++step) {
    angles.push_back(std::copysign(step * kStep_rad, last_rad));
  }
  angles.push_back(last_rad);
  return angles;
}

std::vector<StripMoment> stripMoments(const TrialPlayback& playback) {
  double farthest_rad = 0.0;
  std::int64_t begin_us = -1;
  for (const TrialChunk& chunk : playback.chunks()) {
    for (const Sample& sample : decodeChunk(chunk)) {
      if (begin_us < 0) {
        begin_us = sample.device.time_us;
      }
      if (std::abs(sample.response.angle_rad) > std::abs(farthest_rad)) {
        farthest_rad = sample.response.angle_rad;
      }
    }
  }
  const std::vector<double> angles_rad = stripAngles_rad(farthest_rad);
  const double direction = std::copysign(1.0, farthest_rad);
  std::vector<StripMoment> moments;
  for (const TrialChunk& chunk : playback.chunks()) {
    for (const Sample& sample : decodeChunk(chunk)) {
      while (moments.size() < angles_rad.size() &&
             direction * sample.response.angle_rad >= std::abs(angles_rad[moments.size()])) {
        moments.push_back({angles_rad[moments.size()], sample.device.time_us - begin_us});
      }
    }
  }
  return moments;
}

std::vector<StripFrame> captureStrip(SceneView& view, const Scene& scene, double last_rad) {
  view.setToolVisible(false);
  view.setForce({}, {});
  std::vector<StripFrame> frames;
  for (const double angle_rad : stripAngles_rad(last_rad)) {
    view.setOrgan(scene.stateAt(angle_rad));
    frames.push_back({angleCaption(angle_rad), view.picture()});
  }
  view.setToolVisible(true);
  return frames;
}

QString angleCaption(double angle_rad) {
  const double shown_deg = std::round(degrees(angle_rad) * 10.0) / 10.0;
  const bool whole = shown_deg == std::round(shown_deg);
  const QString size = QLocale().toString(std::abs(shown_deg), 'f', whole ? 0 : 1) + QChar(0x00B0);
  return shown_deg < 0.0 ? QChar(0x2212) + size : size;  // a minus, not a hyphen
}

}  // namespace torsio::gui
