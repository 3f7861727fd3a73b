// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/practice/marker_editor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/scene/orbit_camera.h"
#include "app/gui/scene/scene_view.h"
#include "app/gui/scene/view_frame.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "sim/core/portable_math.h"

namespace torsio::gui {

namespace {

constexpr double kLabelRadius_px = 10.0;
constexpr double kHiddenShare = 0.35;      ///< opacity of a disc on the far side
constexpr double kHiddenNumber = 0.7;      ///< opacity of its number, which stays readable
constexpr double kSkinThickness_mm = 1.0;  ///< tolerance for a marker to be visible

constexpr int kEditorWidth = 440;  // fits the longest name of the shipped markers

QLabel* field(QGridLayout* grid, int row, QWidget* widget) {
  auto* label = new QLabel;
  label->setBuddy(widget);
  label->setProperty("quiet", true);
  grid->addWidget(label, row, 0);
  grid->addWidget(widget, row, 1);
  return label;
}

}  // namespace

void MarkerLabels::setMarkers(std::shared_ptr<const Scene> scene, std::vector<OrganMarker> markers,
                              int chosen) {
  scene_ = std::move(scene);
  markers_ = std::move(markers);
  chosen_ = chosen;
  update();
}

QPointF MarkerLabels::pixelOf(const OrganMarker& marker) const {
  return ViewOverlay::pixelOf(marker.position_m);
}

bool MarkerLabels::isHidden(const OrganMarker& marker) const {
  const QVector3D eye = view().camera().position();
  const QVector3D way = toView(marker.position_m) - eye;
  const std::optional<SightHit> hit = sightHit(scene_->mesh, {eye, way.normalized()});
  return hit && hit->distance_mm < static_cast<double>(way.length()) - kSkinThickness_mm;
}

void MarkerLabels::paintEvent(QPaintEvent*) {
  if (scene_ == nullptr || !view().draws()) {
    return;
  }
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QFont font = painter.font();
  font.setPointSizeF(kSmallText_pt);
  font.setBold(true);
  painter.setFont(font);
  const auto draw = [&](const OrganMarker& marker) {
    const bool chosen = marker.number == chosen_;
    const QRectF disc(pixelOf(marker) - QPointF(kLabelRadius_px, kLabelRadius_px),
                      QSizeF(2.0 * kLabelRadius_px, 2.0 * kLabelRadius_px));
    const bool hidden = isHidden(marker) && !chosen;
    painter.setOpacity(hidden ? kHiddenShare : 1.0);
    painter.setPen(QPen(colours().accent, 2.0));
    painter.setBrush(chosen ? colours().accent : colours().surface);
    painter.drawEllipse(disc);
    painter.setOpacity(hidden ? kHiddenNumber : 1.0);
    painter.setPen(chosen ? colours().onAccent : colours().text);
    painter.drawText(disc, Qt::AlignCenter, QString::number(marker.number));
  };
  for (const OrganMarker& marker : markers_) {
    if (marker.number != chosen_) {
      draw(marker);
    }
  }
  for (const OrganMarker& marker : markers_) {  // the current one on top
    if (marker.number == chosen_) {
      draw(marker);
    }
  }
}

MarkerEditor::MarkerEditor(ShellContext& shell, QWidget* parent)
    : QWidget(parent), shell_(shell), view_(new SceneView(this)), labels_(new MarkerLabels(*view_)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 2 * kSpace, 0, 0);
  row->setSpacing(2 * kSpace);
  row->addWidget(view_, 1);
  row->addWidget(createPanel());
  view_->setToolVisible(false);
  auto* turn = new ViewTurn(*view_);
  connect(turn, &ViewTurn::clicked, this, [this](const QPointF& pixel) {
    if (!placeAt(pixel)) {
      shell_.notify(tr("Click on the organ to move the chosen marker there"));
    }
  });
  connect(list_, &QListWidget::currentRowChanged, this, &MarkerEditor::choose);
  connect(name_, &QLineEdit::textEdited, this, &MarkerEditor::rename);
  connect(section_, &QSpinBox::valueChanged, this, &MarkerEditor::placeOnLattice);
  connect(ridge_, &QSpinBox::valueChanged, this, &MarkerEditor::placeOnLattice);
  connect(add_, &QPushButton::clicked, this, &MarkerEditor::add);
  connect(remove_, &QPushButton::clicked, this, &MarkerEditor::remove);
  connect(reset_, &QPushButton::clicked, this, [this] {
    markers_ = first_;
    fill(0);
    Q_EMIT changed();
  });
  connect(open_, &QPushButton::clicked, this, [this] {
    const QString file = askFileToOpen(this, tr("Open markers"), tr("Markers (*.json)"));
    if (!file.isEmpty()) {
      attempt(shell_, [&] { open(toPath(file)); });
    }
  });
  connect(save_, &QPushButton::clicked, this, [this] {
    const QString file = askFileToSave(this, tr("Save markers"), tr("markers.json"), tr("Markers (*.json)"));
    if (!file.isEmpty()) {
      attempt(shell_, [&] {
        save(toPath(file));
        shell_.notify(tr("Saved %1").arg(file));
      });
    }
  });
}

QWidget* MarkerEditor::createPanel() {
  card_ = new Card(QString(), this);
  card_->setFixedWidth(kEditorWidth);
  hint_ = sentence(card_);
  hint_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  list_ = new QListWidget(card_);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setTextElideMode(Qt::ElideNone);
  list_->setWordWrap(true);
  list_->setResizeMode(QListView::Adjust);
  name_ = new QLineEdit(card_);
  section_ = new QSpinBox(card_);
  ridge_ = new QSpinBox(card_);
  ridge_->setWrapping(true);
  add_ = new QPushButton(card_);
  remove_ = new QPushButton(card_);
  reset_ = new QPushButton(card_);
  open_ = new QPushButton(card_);
  save_ = new QPushButton(card_);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(2 * kSpace);
  grid->setColumnStretch(1, 1);
  nameLabel_ = field(grid, 0, name_);
  sectionLabel_ = field(grid, 1, section_);
  ridgeLabel_ = field(grid, 2, ridge_);
  auto* change = new QHBoxLayout;
  change->addWidget(add_);
  change->addWidget(remove_);
  auto* files = new QHBoxLayout;
  files->addWidget(open_);
  files->addWidget(save_);
  card_->content()->addWidget(hint_);
  card_->content()->addWidget(list_, 1);
  card_->content()->addLayout(change);
  card_->content()->addLayout(grid);
  card_->content()->addLayout(files);
  card_->content()->addWidget(reset_);
  return card_;
}

void MarkerEditor::setOrgan(std::shared_ptr<const Scene> scene, const ViewScene& view,
                            std::vector<OrganMarker> markers) {
  scene_ = std::move(scene);
  first_ = markers;
  markers_ = std::move(markers);
  const QSignalBlocker quietSection(section_);
  const QSignalBlocker quietRidge(ridge_);
  section_->setRange(1, scene_->lattice().sections());
  ridge_->setRange(1, scene_->lattice().ridges());
  view_->setScene(view);
  view_->setMarkersVisible(false);  // replaced by numbers
  view_->setLattice(true);
  fill(0);
}

void MarkerEditor::open(const std::filesystem::path& file) {
  markers_ = readMarkers(file, *scene_);
  fill(0);
  Q_EMIT changed();
}

void MarkerEditor::save(const std::filesystem::path& file) const {
  checkMarkers(markers_, file.string());
  writeMarkers(file, markers_, *scene_);
}

int MarkerEditor::chosen() const {
  return list_->currentRow();
}

void MarkerEditor::fill(int chosen) {
  {
    const QSignalBlocker quiet(list_);
    list_->clear();
    for (const OrganMarker& marker : markers_) {
      list_->addItem(tr("%1  %2").arg(marker.number).arg(toQString(Text(marker.name))));
    }
    list_->setCurrentRow(std::min(chosen, list_->count() - 1));
  }
  choose(list_->currentRow());
}

void MarkerEditor::choose(int row) {
  const bool any = row >= 0 && row < static_cast<int>(markers_.size());
  for (QWidget* widget : std::initializer_list<QWidget*>{name_, section_, ridge_, remove_}) {
    widget->setEnabled(any);
  }
  remove_->setEnabled(any && markers_.size() > 1);
  add_->setEnabled(scene_ != nullptr && markers_.size() < kMaxMarkers);
  if (any) {
    name_->setText(toQString(Text(markers_[static_cast<std::size_t>(row)].name)));
    name_->setCursorPosition(0);
    showPlace();
  }
  showMarkers();
}

void MarkerEditor::showPlace() {
  const OrganMarker& marker = markers_[static_cast<std::size_t>(chosen())];
  std::size_t corner = 0;  // nearest one
  for (std::size_t k = 1; k < 3; ++k) {
    corner = marker.barycentric[k] > marker.barycentric[corner] ? k : corner;
  }
  const SectionLattice& lattice = scene_->lattice();
  const LatticeCoordinate& at = lattice.vertexCoordinates()[scene_->mesh.triangles[marker.face][corner]];
  const QSignalBlocker quietSection(section_);
  const QSignalBlocker quietRidge(ridge_);
  section_->setValue(static_cast<int>(std::lround(at.arc_m / lattice.length_m() * (lattice.sections() - 1))) +
                     1);
  ridge_->setValue(
      static_cast<int>(std::lround(at.angle_rad / (2.0 * kPi) * lattice.ridges())) % lattice.ridges() + 1);
}

void MarkerEditor::placeOnLattice() {
  if (chosen() < 0) {
    return;
  }
  const SectionLattice& lattice = scene_->lattice();
  const LatticePoint point = lattice.surfacePoint(
      {lattice.sectionArc_m(section_->value() - 1), 2.0 * kPi * (ridge_->value() - 1) / lattice.ridges()});
  placeMarker(*scene_, point.triangle, point.barycentric, markers_[static_cast<std::size_t>(chosen())]);
  took();
}

bool MarkerEditor::placeAt(const QPointF& pixel) {
  if (scene_ == nullptr || chosen() < 0) {
    return false;
  }
  const std::optional<SightHit> hit =
      sightHit(scene_->mesh, view_->camera().ray(pixel, QSizeF(view_->size())));
  if (!hit) {
    return false;
  }
  placeMarker(*scene_, hit->face, hit->barycentric, markers_[static_cast<std::size_t>(chosen())]);
  showPlace();
  took();
  return true;
}

void MarkerEditor::took() {
  showMarkers();
  Q_EMIT changed();
}

void MarkerEditor::rename(const QString& name) {
  OrganMarker& marker = markers_[static_cast<std::size_t>(chosen())];
  marker.name = name.toStdString();
  list_->currentItem()->setText(tr("%1  %2").arg(marker.number).arg(name));
  Q_EMIT changed();
}

void MarkerEditor::add() {
  OrganMarker marker = markers_.back();
  marker.number = static_cast<int>(markers_.size()) + 1;
  marker.name = tr("point %1").arg(marker.number).toStdString();
  markers_.push_back(std::move(marker));
  fill(static_cast<int>(markers_.size()) - 1);
  name_->setFocus();
  name_->selectAll();
  Q_EMIT changed();
}

void MarkerEditor::remove() {
  const int row = chosen();
  markers_.erase(markers_.begin() + row);
  for (std::size_t i = 0; i < markers_.size(); ++i) {
    markers_[i].number = static_cast<int>(i) + 1;
  }
  fill(row);
  Q_EMIT changed();
}

void MarkerEditor::showMarkers() {
  labels_->setMarkers(scene_, markers_, chosen() + 1);
}

void MarkerEditor::retranslate() {
  card_->setTitle(tr("Where the markers sit"));
  hint_->setText(
      tr("Choose a marker and click on the organ to move it, or give section and ridge. Drag to turn the "
         "view."));
  nameField(nameLabel_, tr("&Name"));
  nameField(sectionLabel_, tr("&Section"));
  nameField(ridgeLabel_, tr("R&idge"));
  list_->setAccessibleName(tr("Markers"));
  add_->setText(tr("&Add"));
  remove_->setText(tr("Re&move"));
  reset_->setText(tr("&Reset"));
  reset_->setToolTip(tr("The markers that belong to this organ"));
  open_->setText(tr("&Open\u2026"));
  save_->setText(tr("Sa&ve\u2026"));
  save_->setToolTip(tr("For later, and for torsio compare --markers"));
  if (scene_ != nullptr) {
    fill(chosen());
  }
}

void MarkerEditor::setTheme(const Theme& theme) {
  view_->setTheme(theme);
  labels_->setTheme(theme);
}

}  // namespace torsio::gui
