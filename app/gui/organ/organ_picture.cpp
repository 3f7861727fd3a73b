// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/organ/organ_picture.h"

#include <utility>

#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPolygonF>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include "app/gui/scene/orbit_camera.h"
#include "app/gui/scene/scene_view.h"
#include "app/gui/scene/view_frame.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/value_text.h"
#include "sim/core/angle.h"

namespace torsio::gui {

namespace {

constexpr double kDot_px = 5.0;
constexpr double kAxis_px = 2.5;
constexpr double kNameAway_px = 9.0;
constexpr double kNameMargin_px = 4.0;

constexpr int kMaxTwist_deg = 60;  // range of the judged twist, both ways

}  // namespace

void OrganMarks::setAxis(std::vector<Vec3> axis_m, std::vector<OrganLandmark> landmarks) {
  axis_m_ = std::move(axis_m);
  landmarks_ = std::move(landmarks);
  raise();
  update();
}

QString OrganMarks::nameOf(OrganLandmark::Kind kind) {
  switch (kind) {
    case OrganLandmark::Kind::kFixedEnd:
      return tr("held end");
    case OrganLandmark::Kind::kFreeEnd:
      return tr("free end");
    case OrganLandmark::Kind::kWidest:
      return tr("widest");
    case OrganLandmark::Kind::kNarrowest:
      break;
  }
  return tr("narrowest");
}

void OrganMarks::drawName(QPainter& painter, const QPointF& at, const QString& name) const {
  const QFontMetricsF metrics(painter.font());
  QRectF box(at.x() + kNameAway_px, at.y() - 0.5 * metrics.height(),
             metrics.horizontalAdvance(name) + 2.0 * kNameMargin_px, metrics.height());
  if (box.right() > width()) {
    box.moveRight(at.x() - kNameAway_px);
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(colours().surface);
  painter.drawRoundedRect(box, kNameMargin_px, kNameMargin_px);
  painter.setPen(colours().text);
  painter.drawText(box, Qt::AlignCenter, name);
}

void OrganMarks::paintEvent(QPaintEvent*) {
  if (!view().draws()) {
    return;  // the view shows only an explanation
  }
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QFont font = painter.font();
  font.setPointSizeF(kSmallText_pt);
  painter.setFont(font);
  QPolygonF line;
  for (const Vec3& place_m : axis_m_) {
    line << pixelOf(place_m);
  }
  painter.setPen(QPen(colours().accent, kAxis_px, Qt::DashLine));
  painter.drawPolyline(line);
  for (const OrganLandmark& landmark : landmarks_) {
    const QPointF at = pixelOf(landmark.place_m);
    painter.setPen(QPen(colours().surface, 1.0));
    painter.setBrush(colours().accent);
    painter.drawEllipse(at, kDot_px, kDot_px);
    drawName(painter, at, nameOf(landmark.kind));
  }
}

OrganPicture::OrganPicture(QWidget* parent)
    : QWidget(parent), view_(new SceneView(this)), marks_(new OrganMarks(*view_)), none_(sentence(this)) {
  auto* column = bareLayout<QVBoxLayout>(this, kSpace);
  view_->setToolVisible(false);
  none_->setAlignment(Qt::AlignCenter);
  column->addWidget(view_, 1);
  column->addWidget(none_, 1);
  column->addWidget(createBar());
  auto* turn = new ViewTurn(*view_);
  connect(turn, &ViewTurn::clicked, this, &OrganPicture::pickAt);
  setTrial({});
}

QWidget* OrganPicture::createBar() {
  auto* bar = new QWidget(this);
  auto* rows = bareLayout<QVBoxLayout>(bar);
  auto* twisting = new QHBoxLayout;
  twistLabel_ = new QLabel(bar);
  twist_ = new QSlider(Qt::Horizontal, bar);
  twist_->setObjectName(QStringLiteral("trialTwist"));
  twist_->setRange(-kMaxTwist_deg, kMaxTwist_deg);
  twist_->setPageStep(15);
  twistLabel_->setBuddy(twist_);
  angle_ = new QLabel(bar);
  angle_->setMinimumWidth(angle_->fontMetrics().horizontalAdvance(QStringLiteral("\u2212000\u00b0")));
  angle_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  twisting->addWidget(twistLabel_);
  twisting->addWidget(twist_, 1);
  twisting->addWidget(angle_);
  auto* showing = new QHBoxLayout;
  for (QCheckBox** box : {&axis_, &lattice_, &mesh_}) {
    *box = new QCheckBox(bar);
    showing->addWidget(*box);
  }
  axis_->setChecked(true);
  lattice_->setChecked(true);
  showing->addStretch(1);
  for (const auto& [button, preset] :
       {std::pair{&front_, ViewPreset::kFront}, {&side_, ViewPreset::kSide}, {&top_, ViewPreset::kTop}}) {
    *button = new QPushButton(bar);
    showing->addWidget(*button);
    connect(*button, &QPushButton::clicked, this, [this, preset = preset] { look(preset); });
  }
  rows->addLayout(twisting);
  rows->addLayout(showing);
  connect(twist_, &QSlider::valueChanged, this, &OrganPicture::showTwist);
  connect(axis_, &QCheckBox::toggled, this, &OrganPicture::showAxis);
  connect(lattice_, &QCheckBox::toggled, this, [this](bool on) { view_->setLattice(on); });
  connect(mesh_, &QCheckBox::toggled, this, [this](bool on) { view_->setWireframe(on); });
  return bar;
}

void OrganPicture::setTrial(const OrganTrial& trial) {
  trial_ = trial;
  const bool shown = trial_.shown != nullptr;
  const bool twists = trial_.scene != nullptr;
  view_->setVisible(shown);
  none_->setVisible(!shown);
  for (QWidget* needsAxis :
       {static_cast<QWidget*>(twist_), static_cast<QWidget*>(axis_), static_cast<QWidget*>(lattice_)}) {
    needsAxis->setEnabled(twists);
  }
  for (QWidget* needsSurface : {static_cast<QWidget*>(mesh_), static_cast<QWidget*>(front_),
                                static_cast<QWidget*>(side_), static_cast<QWidget*>(top_)}) {
    needsSurface->setEnabled(shown);
  }
  {
    const QSignalBlocker quiet(twist_);
    twist_->setValue(0);
  }
  if (shown) {
    view_->setScene(trial_.view);
    view_->setLattice(twists && lattice_->isChecked());
    view_->setWireframe(mesh_->isChecked());
  }
  showTwist(0);
  showAxis();
}

void OrganPicture::twist(double angle_deg) {
  twist_->setValue(static_cast<int>(angle_deg));
}

void OrganPicture::showTwist(int angle_deg) {
  angle_->setText(tr("%1\u00b0").arg(numberText(angle_deg, 0)));
  twist_->setAccessibleDescription(angle_->text());
  if (trial_.scene != nullptr) {
    view_->setOrgan(state());
  }
}

OrganState OrganPicture::state() const {
  return trial_.stateAt(radians(static_cast<double>(twist_->value())));
}

void OrganPicture::showAxis() {
  const bool on = axis_->isChecked();
  marks_->setAxis(on ? trial_.axis_m : std::vector<Vec3>{},
                  on ? trial_.landmarks : std::vector<OrganLandmark>{});
}

void OrganPicture::look(ViewPreset preset) {
  view_->camera().look(preset);
  view_->applyCamera();
}

bool OrganPicture::pickAt(const QPointF& pixel) {
  if (trial_.shown == nullptr) {
    return false;
  }
  const TriangleMesh& mesh = *trial_.shown;
  TriangleMesh seen = mesh;  // twisted state
  trial_.view.deform(state(), seen.vertices_m);
  const std::optional<SightHit> hit = sightHit(seen, view_->camera().ray(pixel, QSizeF(view_->size())));
  if (!hit) {
    return false;
  }
  Vec3 place_m;
  for (std::size_t k = 0; k < 3; ++k) {
    place_m += hit->barycentric[k] * mesh.vertices_m[mesh.triangles[hit->face][k]];
  }
  Q_EMIT picked(place_m);
  return true;
}

void OrganPicture::retranslate() {
  none_->setText(tr("No picture: no surface could be made from the file. The findings say why."));
  nameField(twistLabel_, tr("Test &twist"));
  twist_->setToolTip(tr("Turns the organ about its own axis, as far as it goes"));
  axis_->setText(tr("Axis and landmarks"));
  lattice_->setText(tr("Sections and ridges"));
  mesh_->setText(tr("Triangles"));
  front_->setText(tr("Front"));
  side_->setText(tr("Side"));
  top_->setText(tr("Top"));
  showTwist(twist_->value());
  marks_->update();
}

void OrganPicture::setTheme(const Theme& theme) {
  view_->setTheme(theme);
  marks_->setTheme(theme);
}

}  // namespace torsio::gui
