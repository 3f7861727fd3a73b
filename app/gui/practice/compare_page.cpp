// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/practice/compare_page.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QComboBox>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QTabWidget>
#include <QVBoxLayout>

#include "app/gui/base/scene_titles.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/practice/marker_editor.h"
#include "app/gui/practice/model_comparison.h"
#include "app/gui/simulator/replay_bar.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/picture.h"
#include "app/gui/widgets/value_text.h"
#include "assessment/statistics/descriptive.h"
#include "sim/core/angle.h"
#include "sim/core/load_decimals.h"

namespace torsio::gui {

namespace {

constexpr int kFormulationsTab = 0;
constexpr int kModelsTab = 1;
constexpr int kMarkersTab = 2;
constexpr int kSteps = 1000;
constexpr double kBeyondTarget = 1.2;
constexpr std::size_t kTimesKept = 31;
constexpr int kStripFrames = 5;

}  // namespace

ComparePage::ComparePage(ShellContext& context, QWidget* parent) : Page(context, parent) {
  sides_[0].formulation = Formulation::kPaper;
  sides_[1].formulation = Formulation::kSaintVenant;
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2 * kSpace, 2 * kSpace, 2 * kSpace, 2 * kSpace);
  tabs_ = new QTabWidget(this);
  column->addWidget(tabs_);
  tabs_->addTab(createFormulations(), QString());
  for (int tab : {kModelsTab, kMarkersTab}) {
    auto* empty = new QWidget(tabs_);  // filled when first shown: three more scenes take a while
    bareLayout<QVBoxLayout>(empty);
    tabs_->insertTab(tab, empty, QString());
  }
  connect(tabs_, &QTabWidget::currentChanged, this, &ComparePage::showTab);
}

QWidget* ComparePage::createFormulations() {
  auto* tab = new QWidget(tabs_);
  auto* column = new QVBoxLayout(tab);
  column->setContentsMargins(0, 2 * kSpace, 0, 0);
  column->setSpacing(2 * kSpace);
  column->addWidget(createBar());
  auto* row = new QHBoxLayout;
  row->setSpacing(2 * kSpace);
  for (Side& side : sides_) {
    row->addWidget(createSide(side), 1);
  }
  column->addLayout(row, 1);
  for (const std::string& id : sceneIds(shell().assets())) {
    organ_->addItem(QString(), toQString(id));
  }
  connect(organ_, &QComboBox::activated, this,
          [this](int index) { load(organ_->itemData(index).toString()); });
  connect(torque_, &QSlider::valueChanged, this,
          [this](int step) { setTorque(top_Nm_ * static_cast<double>(step) / kSteps); });
  connect(shearMap_, &QPushButton::toggled, this, [this](bool on) {
    for (const Side& side : sides_) {
      side.view->setShearVisible(on);
    }
  });
  connect(strip_, &QPushButton::clicked, this, &ComparePage::captureFilmStrip);
  return tab;
}

ModelComparison& ComparePage::models() {
  if (models_ == nullptr) {
    models_ = new ModelComparison(shell(), tabs_->widget(kModelsTab));
    tabs_->widget(kModelsTab)->layout()->addWidget(models_);
    connect(models_, &ModelComparison::organChanged, this, [this] {
      if (markers_ != nullptr) {
        const ComparedScene& organ = models_->organ();
        markers_->setOrgan(organ.loaded.scene, organ.loaded.view, organ.markers);
      }
    });
    models_->retranslate();
    models_->setTheme(theme(shell().themeKind()));
  }
  return *models_;
}

MarkerEditor& ComparePage::markers() {
  if (markers_ == nullptr) {
    markers_ = new MarkerEditor(shell(), tabs_->widget(kMarkersTab));
    tabs_->widget(kMarkersTab)->layout()->addWidget(markers_);
    connect(markers_, &MarkerEditor::changed, this, [this] { models().setMarkers(markers_->markers()); });
    if (models().loaded()) {
      const ComparedScene& organ = models().organ();
      markers_->setOrgan(organ.loaded.scene, organ.loaded.view, organ.markers);
    }
    markers_->retranslate();
    markers_->setTheme(theme(shell().themeKind()));
  }
  return *markers_;
}

void ComparePage::showTab(int index) {
  if (index == kMarkersTab) {
    static_cast<void>(markers());
  }
  if (index != kFormulationsTab && !models().asked()) {
    SceneRequest request;
    request.assets = shell().assets();
    request.id = "forearm";  // the paper's organ
    models().load(request);
  }
}

QWidget* ComparePage::createBar() {
  auto* bar = new QWidget(this);
  auto* row = bareLayout<QHBoxLayout>(bar, kSpace);
  organLabel_ = new QLabel(bar);
  organ_ = new QComboBox(bar);
  organLabel_->setBuddy(organ_);
  torqueLabel_ = new QLabel(bar);
  torque_ = new QSlider(Qt::Horizontal, bar);
  torque_->setRange(0, kSteps);
  torque_->setPageStep(kSteps / 20);
  torqueLabel_->setBuddy(torque_);
  figure_ = new QLabel(bar);
  figure_->setMinimumWidth(figure_->fontMetrics().horizontalAdvance(QStringLiteral("0.00000 N m")) + kSpace);
  shearMap_ = new QPushButton(bar);
  shearMap_->setCheckable(true);
  strip_ = new QPushButton(bar);
  row->addWidget(organLabel_);
  row->addWidget(organ_);
  row->addSpacing(kSpace);
  row->addWidget(torqueLabel_);
  row->addWidget(torque_, 1);
  row->addWidget(figure_);
  row->addSpacing(kSpace);
  row->addWidget(shearMap_);
  row->addWidget(strip_);
  return bar;
}

QWidget* ComparePage::createSide(Side& side) {
  side.card = new Card(QString(), this);
  side.view = new SceneView(side.card);
  side.view->setToolVisible(false);
  side.card->content()->addWidget(side.view, 1);
  auto* figures = new QHBoxLayout;
  for (QLabel** label : {&side.angle, &side.shear, &side.time}) {
    *label = new QLabel(side.card);
    figures->addWidget(*label, 1);
  }
  side.card->content()->addLayout(figures);
  return side.card;
}

void ComparePage::showModels() {
  tabs_->setCurrentIndex(kModelsTab);
}

void ComparePage::showMarkers() {
  tabs_->setCurrentIndex(kMarkersTab);
}

void ComparePage::enter(const QVariant& argument) {
  if (argument.canConvert<SceneRequest>()) {  // an organ of the simulator, to compare with finite elements
                                              // and springs
    models().load(argument.value<SceneRequest>());
    showModels();
    return;
  }
  if (loaded()) {
    return;
  }
  const QString organ = QStringLiteral("stomach");
  organ_->setCurrentIndex(organ_->findData(organ));
  load(organ);
}

void ComparePage::load(const QString& organ) {
  SceneRequest request;
  request.assets = shell().assets();
  request.id = organ.toStdString();
  request.noRod = true;  // both formulations twist the organ about its own axis
  const std::array<Formulation, 2> formulations{sides_[0].formulation, sides_[1].formulation};
  shell().run(
      this, tr("Loading the models"),
      [request, formulations](SessionContext&, const ProgressCallback& progress) {
        std::array<LoadedScene, 2> scenes;
        for (std::size_t i = 0; i < scenes.size(); ++i) {
          progress({request.id, static_cast<double>(i) / 2.0, -1.0});
          SceneRequest one = request;
          one.formulation = formulations[i];
          scenes[i] = loadSceneForView(one);
        }
        return scenes;
      },
      [this](std::array<LoadedScene, 2> scenes) { adopt(std::move(scenes)); });
}

void ComparePage::adopt(std::array<LoadedScene, 2> scenes) {
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    sides_[i].scene = std::move(scenes[i]);
    sides_[i].times_us.clear();
    sides_[i].view->setScene(sides_[i].scene.view);
  }
  const Scene& scene = *sides_[1].scene.scene;
  top_Nm_ = kBeyondTarget * std::abs(scene.torqueAt_Nm(scene.pattern.targetAngle_rad));
  const QSignalBlocker quiet(torque_);
  torque_->setValue(static_cast<int>(kSteps / kBeyondTarget));
  setTorque(top_Nm_ / kBeyondTarget);
}

void ComparePage::setTorque(double torque_Nm) {
  torque_Nm_ = torque_Nm;
  figure_->setText(tr("%1 N m").arg(numberText(torque_Nm, kModelTorqueDecimals)));
  torque_->setAccessibleDescription(figure_->text());
  apply();
}

void ComparePage::apply() {
  if (!loaded()) {
    return;
  }
  std::vector<Vec3> vertices_m;
  for (Side& side : sides_) {
    const Scene& scene = *side.scene.scene;
    vertices_m.resize(scene.mesh.vertices_m.size());
    QElapsedTimer timer;
    timer.start();
    const OrganState state = scene.stateForTorque(torque_Nm_);
    scene.deform(state, vertices_m);
    side.times_us.push_back(static_cast<double>(timer.nsecsElapsed()) * 1e-3);
    if (side.times_us.size() > kTimesKept) {
      side.times_us.erase(side.times_us.begin());
    }
    side.view->setOrgan(state);
    show(side);
  }
}

void ComparePage::show(Side& side) {
  const Scene& scene = *side.scene.scene;
  const OrganState state = scene.stateForTorque(torque_Nm_);
  side.angle->setText(tr("Angle  %1\u00b0").arg(numberText(degrees(state.twist.graspAngle_rad), 1)));
  side.shear->setText(tr("Largest shear  %1 kPa").arg(numberText(scene.peakShear_Pa(state) / 1000.0, 2)));
  side.time->setText(tr("Computed in %1 \u00b5s").arg(numberText(medianOf(side.times_us), 0)));
}

void ComparePage::captureFilmStrip() {
  if (!loaded() || !SceneView::platformCanRender()) {
    shell().notify(tr("There is no picture to capture here"));
    return;
  }
  const QString file =
      askFileToSave(this, tr("Save film strip"), tr("film-strip.png"), tr("PNG pictures (*.png)"));
  if (file.isEmpty()) {
    return;
  }
  const double before_Nm = torque_Nm_;
  std::vector<std::vector<StripFrame>> rows(sides_.size());
  for (int i = 0; i < kStripFrames; ++i) {
    setTorque(top_Nm_ / kBeyondTarget * i / (kStripFrames - 1));
    for (std::size_t s = 0; s < sides_.size(); ++s) {
      const QString caption = tr("%1, %2").arg(figure_->text(), sides_[s].angle->text());
      rows[s].push_back({caption, sides_[s].view->picture()});
    }
  }
  setTorque(before_Nm);
  attempt(shell(), [&] {
    writePicture(filmStrip(rows), file.toStdString());
    shell().notify(tr("Saved %1").arg(file));
  });
}

void ComparePage::nameTabs() {
  tabs_->setTabText(kFormulationsTab, tr("Two formulations"));
  tabs_->setTabText(kModelsTab, tr("Finite elements and springs"));
  tabs_->setTabText(kMarkersTab, tr("Markers"));
}

void ComparePage::retranslate() {
  nameTabs();
  if (models_ != nullptr) {
    models_->retranslate();
  }
  if (markers_ != nullptr) {
    markers_->retranslate();
  }
  nameField(organLabel_, tr("&Organ"));
  nameField(torqueLabel_, tr("&Torque"));
  shearMap_->setText(tr("Shear stress"));
  strip_->setText(tr("Film strip\u2026"));
  strip_->setToolTip(tr("Saves both models at five steps of the torque as one picture"));
  sides_[0].card->setTitle(tr("As in the paper"));
  sides_[1].card->setTitle(tr("Saint-Venant"));
  SceneTitles titles(shell().assets());
  for (int i = 0; i < organ_->count(); ++i) {
    organ_->setItemText(i, titles.scene(organ_->itemData(i).toString().toStdString()));
  }
  if (loaded()) {
    setTorque(torque_Nm_);
  }
}

void ComparePage::applyTheme(const Theme& theme) {
  for (const Side& side : sides_) {
    side.view->setTheme(theme);
  }
  if (models_ != nullptr) {
    models_->setTheme(theme);
  }
  if (markers_ != nullptr) {
    markers_->setTheme(theme);
  }
}

PageEntry comparePage() {
  return {PageId::kCompare, [](ShellContext& context) -> Page* { return new ComparePage(context); }};
}

namespace {

void waitFor(const std::function<bool()>& done) {
  while (!done()) {
    QCoreApplication::processEvents();
  }
}

/// Runs a quick comparison for a screenshot, with real times and few elements.
void compareQuickly(ComparePage& page) {
  waitFor([&page] { return page.loaded(); });
  page.showModels();
  waitFor([&page] { return page.models().loaded(); });
  ComparisonOptions options;
  options.ramp_s = 0.2;
  options.rings = 1;
  page.models().compare(options);
  waitFor([&page] { return page.models().result() != nullptr; });
}

}  // namespace

std::vector<ScreenEntry> compareScreens() {
  return {{.name = QStringLiteral("compare"),
           .role = QStringLiteral("rater"),
           .pageId = PageId::kCompare,
           .argument = [](SessionContext&) { return QVariant(); },
           .prepare =
               [](Page& page) {
                 auto& compare = static_cast<ComparePage&>(page);
                 waitFor([&compare] { return compare.loaded(); });
               }},
          {.name = QStringLiteral("compare-models"),
           .role = QStringLiteral("rater"),
           .pageId = PageId::kCompare,
           .argument = [](SessionContext&) { return QVariant(); },
           .prepare = [](Page& page) { compareQuickly(static_cast<ComparePage&>(page)); }},
          {.name = QStringLiteral("compare-markers"),
           .role = QStringLiteral("rater"),
           .pageId = PageId::kCompare,
           .argument = [](SessionContext&) { return QVariant(); },
           .prepare =
               [](Page& page) {
                 auto& compare = static_cast<ComparePage&>(page);
                 waitFor([&compare] { return compare.loaded(); });
                 compare.showMarkers();
                 waitFor([&compare] { return compare.models().loaded(); });
               }}};
}

}  // namespace torsio::gui
