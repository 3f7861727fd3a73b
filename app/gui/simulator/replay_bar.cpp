// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/simulator/replay_bar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

#include "app/gui/scene/scene_view.h"
#include "app/gui/scene/view_frame.h"
#include "app/gui/widgets/icons.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "app/outputs/charts/typeface.h"
#include "app/services/recording/trial_playback.h"
#include "sim/core/angle.h"
#include "sim/record/sample_codec.h"

namespace torsio::gui {

namespace {

constexpr double kSpeeds[] = {0.25, 0.5, 1.0, 2.0, 4.0};
constexpr int kSliderStep_us = 10'000;

constexpr int kGap = 8;
constexpr std::size_t kFramesInARow = 4;
constexpr double kStep_rad = std::numbers::pi / 6.0;
constexpr double kNear_rad = radians(0.5);  // a last step of half a degree would look the same

/// A viewpoint of a sheet of sides.
struct Side {
  const char* name;
  float azimuth_deg;
  float elevation_deg;
};
constexpr std::array kSides{
    Side{QT_TRANSLATE_NOOP("torsio::gui::FilmStrip", "front"), 0.0F, 0.0F},
    Side{QT_TRANSLATE_NOOP("torsio::gui::FilmStrip", "left"), 90.0F, 0.0F},
    Side{QT_TRANSLATE_NOOP("torsio::gui::FilmStrip", "back"), 180.0F, 0.0F},
    Side{QT_TRANSLATE_NOOP("torsio::gui::FilmStrip", "right"), -90.0F, 0.0F},
    Side{QT_TRANSLATE_NOOP("torsio::gui::FilmStrip", "above"), 0.0F, 90.0F},
    Side{QT_TRANSLATE_NOOP("torsio::gui::FilmStrip", "below"), 0.0F, -90.0F},
};

/// Centres the organ in its present shape.
void frameOrgan(SceneView& view, const Scene& scene, const OrganState& state) {
  constexpr float kNearer = 0.92F;  // the bounding ball has spare room at the sides
  std::vector<Vec3> skin_m(scene.mesh.vertices_m.size());
  scene.deform(state, skin_m);
  QVector3D low = toView(skin_m.front());
  QVector3D high = low;
  for (const Vec3& place_m : skin_m) {
    const QVector3D p = toView(place_m);
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  view.camera().frame(0.5F * (low + high), 0.5F * kNearer * (high - low).length(), QSizeF(view.size()));
}

QImage square(const QImage& picture) {
  const int side = std::min(picture.width(), picture.height());
  return picture.copy((picture.width() - side) / 2, (picture.height() - side) / 2, side, side);
}

}  // namespace

ReplayBar::ReplayBar(QWidget* parent)
    : QWidget(parent),
      theme_(&theme(ThemeKind::kLight)),
      play_(new QToolButton(this)),
      position_(new QSlider(Qt::Horizontal, this)),
      time_(new QLabel(this)),
      speed_(new QComboBox(this)),
      close_(new QToolButton(this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(2 * kSpace, kSpace, 2 * kSpace, kSpace);
  row->setSpacing(kSpace + 4);
  play_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  close_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  position_->setPageStep(100);
  for (const double speed : kSpeeds) {
    speed_->addItem(QString(), speed);
  }
  speed_->setCurrentIndex(2);
  row->addWidget(play_);
  row->addWidget(position_, 1);
  row->addWidget(time_);
  row->addWidget(speed_);
  row->addWidget(close_);

  connect(play_, &QToolButton::clicked, this, &ReplayBar::playToggled);
  connect(close_, &QToolButton::clicked, this, &ReplayBar::closed);
  connect(position_, &QSlider::valueChanged, this,
          [this](int step) { Q_EMIT soughtTo(static_cast<qint64>(step) * kSliderStep_us); });
  connect(speed_, &QComboBox::activated, this,
          [this](int index) { Q_EMIT speedChosen(speed_->itemData(index).toDouble()); });
  retranslate();
}

void ReplayBar::retranslate() {
  close_->setText(tr("Close replay"));
  position_->setAccessibleName(tr("Position in the recording"));
  time_->setAccessibleName(tr("Time"));
  speed_->setAccessibleName(tr("Speed"));
  for (int i = 0; i < speed_->count(); ++i) {
    speed_->setItemText(i, tr("%1 \u00d7 speed").arg(QLocale().toString(speed_->itemData(i).toDouble())));
  }
  setTheme(*theme_);
}

void ReplayBar::setTheme(const Theme& theme) {
  theme_ = &theme;
  play_->setIcon(icon(playing_ ? QStringLiteral("pause") : QStringLiteral("play"), theme));
  play_->setText(playing_ ? tr("Pause") : tr("Play"));
  close_->setIcon(icon(QStringLiteral("close"), theme));
}

void ReplayBar::show(const TrialPlayback* playback) {
  if (playback == nullptr) {
    return;
  }
  if (playing_ != playback->playing()) {
    playing_ = playback->playing();
    setTheme(*theme_);
  }
  const QSignalBlocker quiet(position_);
  position_->setRange(0, static_cast<int>(playback->duration_us() / kSliderStep_us));
  if (!position_->isSliderDown()) {
    position_->setValue(static_cast<int>(playback->position_us() / kSliderStep_us));
  }
  const QString text =
      clockTenthsOf(playback->position_us()) + QStringLiteral(" / ") + clockTenthsOf(playback->duration_us());
  if (time_->text() != text) {
    time_->setText(text);
  }
}

QImage filmStrip(const std::vector<std::vector<StripFrame>>& rows, int width) {
  if (rows.empty() || rows.front().empty() || rows.front().front().picture.isNull()) {
    return {};
  }
  const QSize first = rows.front().front().picture.size();
  const QSize cell(width, width * first.height() / first.width());
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

std::vector<std::vector<StripFrame>> captureSides(SceneView& view, const Scene& scene, double angle_rad) {
  view.setToolVisible(false);
  view.setForce({}, {});
  view.setSurroundingsVisible(false);
  std::vector<std::vector<StripFrame>> rows;
  for (const double shown_rad : {0.0, angle_rad}) {
    const OrganState state = scene.stateAt(shown_rad);
    view.setOrgan(state);
    frameOrgan(view, scene, state);
    rows.emplace_back();
    for (const Side& side : kSides) {
      view.camera().lookFrom(side.azimuth_deg, side.elevation_deg);
      view.applyCamera();
      const QString name = QCoreApplication::translate("torsio::gui::FilmStrip", side.name);
      rows.back().push_back({name + QStringLiteral(", ") + angleCaption(shown_rad), square(view.picture())});
    }
  }
  view.frameOrgan();
  view.setSurroundingsVisible(true);
  view.setToolVisible(true);
  return rows;
}

QString angleCaption(double angle_rad) {
  const double shown_deg = std::round(degrees(angle_rad) * 10.0) / 10.0;
  const bool whole = shown_deg == std::round(shown_deg);
  return numberText(shown_deg, whole ? 0 : 1) + QChar(0x00B0);
}

}  // namespace torsio::gui
