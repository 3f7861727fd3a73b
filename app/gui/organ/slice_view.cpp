// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/organ/slice_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include "sim/imaging/surface/voxel_mask.h"

namespace torsio::gui {

namespace {

void paintOver(ScanPreview& preview, const BrushDab& dab) {
  const ScanVolume& volume = preview.volume;
  eachVoxelIn(dab, volume, {0, 0, 0}, volume.count, [&](std::size_t x, std::size_t y, std::size_t z) {
    preview.within[volume.index(x, y, z)] = dab.adds ? 1 : 0;
  });
}

constexpr double kNotch = 120.0;  // of the wheel, eighths of a degree
constexpr int kPage = 10;         // slices per Page Up or Page Down
constexpr double kWindowPerPixel_HU = 2.0;
constexpr double kLeastWidth_HU = 10.0;
constexpr double kMaskShare = 0.45;  // weight of the mask's colour
constexpr double kLineShare = 0.7;
constexpr double kSeed_px = 6.0;
constexpr int kMargin_px = 4;

std::array<double, 3> stepsOf(const ScanVolume& volume) {
  return {norm(volume.step_mm[0]), norm(volume.step_mm[1]), norm(volume.step_mm[2])};
}

}  // namespace

void SliceState::setPreview(ScanPreview scan) {
  const double level_HU = level;
  const double width_HU = width;
  *this = {};
  level = level_HU;
  width = width_HU;
  preview = std::move(scan);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    at[axis] = static_cast<int>(preview.volume.count[axis] / 2);
  }
}

void SliceState::setFound(ScanPreview organ) {
  preview = std::move(organ);
  found = preview.within;
  repaint();
}

void SliceState::repaint() {
  preview.within = found;
  for (const std::vector<BrushDab>& stroke : strokes) {
    for (const BrushDab& dab : stroke) {
      paintOver(preview, dab);
    }
  }
}

void SliceState::paint(const BrushDab& dab) {
  if (found.empty() || strokes.empty()) {
    return;
  }
  strokes.back().push_back(dab);
  paintOver(preview, dab);
}

void SliceState::undoStroke() {
  if (!strokes.empty()) {
    strokes.pop_back();
    repaint();
  }
}

void SliceState::clearStrokes() {
  strokes.clear();
  repaint();
}

std::vector<BrushDab> SliceState::dabs() const {
  std::vector<BrushDab> all;
  for (const std::vector<BrushDab>& stroke : strokes) {
    all.insert(all.end(), stroke.begin(), stroke.end());
  }
  return all;
}

Vec3 SliceState::placeOf_mm(const PreviewVoxel& voxel) const {
  return preview.volume.place_mm(
      {static_cast<double>(voxel[0]), static_cast<double>(voxel[1]), static_cast<double>(voxel[2])});
}

std::optional<ScanBox> SliceState::box_mm() const {
  if (!box) {
    return std::nullopt;
  }
  return ScanBox{placeOf_mm((*box)[0]), placeOf_mm((*box)[1])};
}

std::optional<double> SliceState::volume_ml() const {
  if (preview.within.empty()) {
    return std::nullopt;
  }
  constexpr double kMillilitre_mm3 = 1000.0;
  const auto voxels = static_cast<double>(std::count(preview.within.begin(), preview.within.end(), 1));
  return std::abs(preview.volume.voxel_mm3()) * voxels / kMillilitre_mm3;
}

SliceView::SliceView(SliceState& state, SlicePlane plane, QWidget* parent)
    : QWidget(parent),
      state_(state),
      plane_(plane),
      across_(plane == SlicePlane::kSagittal ? 1 : 0),
      along_(plane == SlicePlane::kAxial ? 1 : 2),
      upwards_(plane != SlicePlane::kAxial),
      theme_(theme(ThemeKind::kLight)) {
  setMinimumSize(160, 130);
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void SliceView::setTheme(const Theme& theme) {
  theme_ = theme;
  refresh();
}

void SliceView::setBrush(double radius_mm) {
  brush_mm_ = radius_mm;
  update();
}

void SliceView::refresh() {
  picture_ = state_.empty() ? QImage() : slicePicture();
  update();
}

QImage SliceView::slicePicture() const {
  const ScanVolume& volume = state_.preview.volume;
  const auto width = static_cast<int>(volume.count[across_]);
  const auto height = static_cast<int>(volume.count[along_]);
  QImage picture(width, height, QImage::Format_RGB32);
  const double black = state_.level - 0.5 * state_.width;
  const QColor colour = theme_.accent.lightnessF() > 0.5 ? theme_.accent : theme_.accent.lighter(180);
  const auto mixed = [](int grey, int part) {
    return static_cast<int>((1.0 - kMaskShare) * grey + kMaskShare * part);
  };
  PreviewVoxel voxel = clamped(state_.at);
  for (int row = 0; row < height; ++row) {
    voxel[along_] = upwards_ ? height - 1 - row : row;
    auto* line = reinterpret_cast<QRgb*>(picture.scanLine(row));
    for (int x = 0; x < width; ++x) {
      voxel[across_] = x;
      const std::size_t n =
          volume.index(static_cast<std::size_t>(voxel[0]), static_cast<std::size_t>(voxel[1]),
                       static_cast<std::size_t>(voxel[2]));
      const double share = (volume.values[n] - black) / state_.width;
      const int grey = static_cast<int>(255.0 * std::clamp(share, 0.0, 1.0));
      const bool organ = !state_.preview.within.empty() && state_.preview.within[n] != 0;
      line[x] = organ
                    ? qRgb(mixed(grey, colour.red()), mixed(grey, colour.green()), mixed(grey, colour.blue()))
                    : qRgb(grey, grey, grey);
    }
  }
  return picture;
}

QRectF SliceView::slicePlace() const {
  const ScanVolume& volume = state_.preview.volume;
  const std::array<double, 3> step = stepsOf(volume);
  const double width_mm = step[across_] * static_cast<double>(volume.count[across_]);
  const double height_mm = step[along_] * static_cast<double>(volume.count[along_]);
  if (!(width_mm > 0.0 && height_mm > 0.0)) {
    return {};
  }
  const double scale = std::min(width() / width_mm, height() / height_mm);
  const QSizeF size(scale * width_mm, scale * height_mm);
  return {QPointF(0.5 * (width() - size.width()), 0.5 * (height() - size.height())), size};
}

PreviewVoxel SliceView::clamped(PreviewVoxel voxel) const {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto last = static_cast<int>(state_.preview.volume.count[axis]) - 1;
    voxel[axis] = std::clamp(voxel[axis], 0, std::max(last, 0));
  }
  return voxel;
}

std::optional<PreviewVoxel> SliceView::voxelAt(const QPointF& pixel) const {
  const QRectF place = slicePlace();
  if (state_.empty() || !place.contains(pixel)) {
    return std::nullopt;
  }
  const ScanVolume& volume = state_.preview.volume;
  const auto voxelOf = [&](double share, std::size_t axis) {
    return static_cast<int>(std::floor(share * static_cast<double>(volume.count[axis])));
  };
  const double down = (pixel.y() - place.top()) / place.height();
  PreviewVoxel voxel = state_.at;
  voxel[across_] = voxelOf((pixel.x() - place.left()) / place.width(), across_);
  voxel[along_] = voxelOf(upwards_ ? 1.0 - down : down, along_);
  return clamped(voxel);
}

QPointF SliceView::pixelOf(const PreviewVoxel& voxel) const {
  const QRectF place = slicePlace();
  const ScanVolume& volume = state_.preview.volume;
  const auto shareOf = [&](std::size_t axis) {
    return (voxel[axis] + 0.5) / static_cast<double>(volume.count[axis]);
  };
  const double down = upwards_ ? 1.0 - shareOf(along_) : shareOf(along_);
  return {place.left() + shareOf(across_) * place.width(), place.top() + down * place.height()};
}

void SliceView::drawMarks(QPainter& painter) const {
  QColor line = theme_.accent.lightnessF() > 0.5 ? theme_.accent : theme_.accent.lighter(180);
  line.setAlphaF(static_cast<float>(kLineShare));
  painter.setPen(QPen(line, 1.0));
  const QRectF place = slicePlace();
  const QPointF here = pixelOf(state_.at);
  painter.drawLine(QPointF(place.left(), here.y()), QPointF(place.right(), here.y()));
  painter.drawLine(QPointF(here.x(), place.top()), QPointF(here.x(), place.bottom()));
  painter.setBrush(Qt::NoBrush);
  const QColor mark = theme_.caution.lightnessF() > 0.5 ? theme_.caution : theme_.caution.lighter(190);
  if (state_.box) {
    painter.setPen(QPen(mark, 2.0, Qt::DashLine));
    painter.drawRect(QRectF(pixelOf((*state_.box)[0]), pixelOf((*state_.box)[1])).normalized());
  }
  if (state_.seed_mm) {
    const Vec3 at = state_.preview.volume.voxelAt(*state_.seed_mm);
    const PreviewVoxel seed{static_cast<int>(std::lround(at.x)), static_cast<int>(std::lround(at.y)),
                            static_cast<int>(std::lround(at.z))};
    const auto cut = static_cast<std::size_t>(plane_);
    painter.setPen(QPen(mark, 2.0, seed[cut] == state_.at[cut] ? Qt::SolidLine : Qt::DotLine));
    painter.drawEllipse(pixelOf(seed), kSeed_px, kSeed_px);
  }
  if (brush_mm_ > 0.0 && mouse_) {
    const double radius_px =
        brush_mm_ * place.width() /
        (stepsOf(state_.preview.volume)[across_] * static_cast<double>(state_.preview.volume.count[across_]));
    painter.setPen(QPen(mark, 1.5));
    painter.drawEllipse(*mouse_, radius_px, radius_px);
  }
}

void SliceView::drawLetters(QPainter& painter) const {
  const bool sagittal = plane_ == SlicePlane::kSagittal;
  const QString left = sagittal ? tr("front") : tr("right");
  const QString right = sagittal ? tr("back") : tr("left");
  const QString top = upwards_ ? tr("head") : tr("front");
  const QString bottom = upwards_ ? tr("feet") : tr("back");
  QFont font = painter.font();
  font.setPointSizeF(kSmallText_pt);
  painter.setFont(font);
  painter.setPen(Qt::white);
  const QRect inner = rect().adjusted(kMargin_px, kMargin_px, -kMargin_px, -kMargin_px);
  painter.drawText(inner, Qt::AlignLeft | Qt::AlignVCenter, left);
  painter.drawText(inner, Qt::AlignRight | Qt::AlignVCenter, right);
  painter.drawText(inner, Qt::AlignHCenter | Qt::AlignTop, top);
  painter.drawText(inner, Qt::AlignHCenter | Qt::AlignBottom, bottom);
}

void SliceView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  if (picture_.isNull()) {
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(slicePlace(), picture_);
  painter.setRenderHint(QPainter::Antialiasing);
  drawMarks(painter);
  drawLetters(painter);
  if (hasFocus()) {
    painter.setPen(QPen(theme_.accent, 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(rect().adjusted(1, 1, -1, -1));
  }
}

void SliceView::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::RightButton) {
    windowing_ = event->position();
    return;
  }
  if (const auto voxel = voxelAt(event->position()); voxel && event->button() == Qt::LeftButton) {
    Q_EMIT pressed(*voxel);
  }
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
  mouse_ = event->position();
  if (windowing_ && (event->buttons() & Qt::RightButton) != 0) {
    const QPointF by = event->position() - *windowing_;
    windowing_ = event->position();
    state_.width = std::max(kLeastWidth_HU, state_.width + kWindowPerPixel_HU * by.x());
    state_.level -= kWindowPerPixel_HU * by.y();
    Q_EMIT moved();
    return;
  }
  if ((event->buttons() & Qt::LeftButton) != 0) {
    const QRectF place = slicePlace();
    const QPointF inside(std::clamp(event->position().x(), place.left(), place.right() - 0.01),
                         std::clamp(event->position().y(), place.top(), place.bottom() - 0.01));
    if (const auto voxel = voxelAt(inside)) {
      Q_EMIT dragged(*voxel);
    }
  }
  update();
}

void SliceView::mouseReleaseEvent(QMouseEvent* event) {
  windowing_.reset();
  if (event->button() == Qt::LeftButton) {
    Q_EMIT released();
  }
}

void SliceView::leaveEvent(QEvent*) {
  mouse_.reset();
  update();
}

void SliceView::step(int slices) {
  if (state_.empty()) {
    return;
  }
  state_.at[static_cast<std::size_t>(plane_)] += slices;
  state_.at = clamped(state_.at);
  Q_EMIT moved();
}

void SliceView::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / kNotch;
  if (notches == 0.0) {
    return;
  }
  step(notches > 0.0 ? std::max(1, static_cast<int>(notches)) : std::min(-1, static_cast<int>(notches)));
  event->accept();
}

void SliceView::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Up:
    case Qt::Key_Right:
      step(1);
      return;
    case Qt::Key_Down:
    case Qt::Key_Left:
      step(-1);
      return;
    case Qt::Key_PageUp:
      step(kPage);
      return;
    case Qt::Key_PageDown:
      step(-kPage);
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace torsio::gui
