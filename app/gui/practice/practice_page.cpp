// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/practice/practice_page.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>

#include <QComboBox>
#include <QCoreApplication>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/organ/instrument_panel.h"
#include "app/gui/organ/organ_picture.h"
#include "app/gui/organ/organ_wizard.h"
#include "app/gui/organ/scan_panel.h"
#include "app/gui/simulator/pointer_keys.h"
#include "app/gui/simulator/posed_states.h"
#include "app/gui/trainee/station_desk.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/form.h"
#include "app/services/recording/unstored_trials.h"
#include "assessment/attempt/trial_listing.h"
#include "sim/core/time_units.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "sim/geometry/query/collision_mesh.h"
#include "sim/imaging/surface/scan_preview.h"
#include "sim/scene/instrument_import.h"

namespace torsio::gui {

namespace {

/// Holds the organ half-way through the exercise for a screenshot, regardless of the machine's speed.
void holdAtTarget(SimulatorWindow& simulator) {
  while (simulator.controller().loading()) {
    QCoreApplication::processEvents();
  }
  SceneRequest request = simulator.controller().request();
  request.assets = simulator.assets();
  if (request.id.empty()) {
    request.id = "stomach";
  }
  simulator.controller().adopt(request, loadSceneForView(request));
  const Scene& scene = *simulator.controller().scene();
  LiveState held = scriptedTwist(scene, scene.pattern.targetAngle_rad);
  held.targetAngle_rad = simulator.controller().target_rad();
  simulator.controller().freeze(held);
}

OrganWizard& bringStomach(Page& page, const QString& anatomy) {
  OrganWizard& wizard = static_cast<PracticePage&>(page).bringOrgan();
  wizard.begin();
  auto& chosen = child<QComboBox>(wizard, "anatomy");
  chosen.setCurrentIndex(chosen.findData(anatomy));
  wizard.judgeMesh(wizard.assets() / "organs" / "stomach.ply");
  while (!wizard.trial()) {
    QCoreApplication::processEvents();
  }
  return wizard;
}

/// CT value of a gas-filled stomach at this distance outside the lumen.
std::int16_t valueAround(double distance_mm) {
  constexpr double kWall_mm = 4.0;
  constexpr std::int16_t kGas_HU = -1000;
  constexpr std::int16_t kTissue_HU = 40;
  constexpr std::int16_t kFat_HU = -100;
  return distance_mm < 0.0 ? kGas_HU : distance_mm < kWall_mm ? kTissue_HU : kFat_HU;
}

/// Makes synthetic slices of a shipped organ, with the mask of its lumen.
ScanPreview stomachSlices(const std::filesystem::path& assets) {
  constexpr double kVoxel_mm = 2.5;
  constexpr double kMargin_mm = 15.0;
  constexpr double kMillimetres = 1000.0;
  const TriangleMesh mesh = importMesh(assets / "organs" / "stomach.ply");
  Vec3 low = mesh.vertices_m.front();
  Vec3 high = low;
  for (const Vec3& v : mesh.vertices_m) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
  }
  ScanPreview preview;
  ScanVolume& volume = preview.volume;
  const Vec3 side_mm = kMillimetres * (high - low) + Vec3{2, 2, 2} * kMargin_mm;
  const std::array<double, 3> sides{side_mm.x, side_mm.y, side_mm.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    volume.count[axis] = static_cast<std::size_t>(sides[axis] / kVoxel_mm);
  }
  volume.step_mm = {Vec3{kVoxel_mm, 0, 0}, Vec3{0, kVoxel_mm, 0}, Vec3{0, 0, kVoxel_mm}};
  volume.origin_mm = kMillimetres * low - Vec3{1, 1, 1} * kMargin_mm;
  const CollisionMesh surface(mesh);
  std::uint32_t near = 0;
  for (std::size_t n = 0; n < volume.count[0] * volume.count[1] * volume.count[2]; ++n) {
    const std::size_t row = n / volume.count[0];
    const std::size_t slice = row / volume.count[1];
    const Vec3 place_mm =
        volume.place_mm({static_cast<double>(n % volume.count[0]), static_cast<double>(row % volume.count[1]),
                         static_cast<double>(slice)});
    const SurfacePoint point = surface.closest(place_mm / kMillimetres, near);
    near = point.triangle;
    const double distance_mm = kMillimetres * point.distance_m;
    volume.values.push_back(valueAround(distance_mm));
    preview.within.push_back(distance_mm < 0.0 ? 1 : 0);
  }
  return preview;
}

void showSlices(Page& page) {
  OrganWizard& wizard = static_cast<PracticePage&>(page).bringOrgan();
  wizard.begin();
  ScanPreview preview = stomachSlices(wizard.assets());
  wizard.showScan({}, preview);
  ScanPanel& panel = wizard.scanPanel();
  auto& tissue = child<QComboBox>(wizard, "tissue");
  tissue.setCurrentIndex(static_cast<int>(ScanTissue::kGasLumen));
  panel.setFound(std::move(preview));
  panel.lookAt({55.0, 10.0, -10.0});
}

/// Shows the shipped grasper as if its CAD model had been imported.
void showInstrument(Page& page) {
  OrganWizard& wizard = static_cast<PracticePage&>(page).bringOrgan();
  const std::filesystem::path folder = wizard.assets() / "instruments";
  TriangleMesh whole;
  for (const char* part : {"shaft", "jaw_upper", "jaw_lower"}) {
    const TriangleMesh mesh =
        importMesh(folder / (std::string("grasper_") + part + ".ply"), {.organ = false});
    const auto first = static_cast<std::uint32_t>(whole.vertices_m.size());
    whole.vertices_m.insert(whole.vertices_m.end(), mesh.vertices_m.begin(), mesh.vertices_m.end());
    for (const TriangleMesh::Triangle& t : mesh.triangles) {
      whole.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
  }
  wizard.begin();
  wizard.showToolMesh(folder / "grasper_shaft.ply");
  wizard.instrument().setTool(toolOfMesh({std::move(whole), {}}, wizard.instrument().meshRequest()));
}

ScreenEntry organScreen(const char* name, std::function<void(Page&)> prepare) {
  return {.name = QString::fromLatin1(name),
          .role = QStringLiteral("trainee"),
          .pageId = PageId::kPractice,
          .argument = [](SessionContext&) { return QVariant(); },
          .prepare = std::move(prepare)};
}

}  // namespace

PracticePage::PracticePage(ShellContext& context, const StationDesk& desk, QWidget* parent)
    : Page(context, parent),
      own_(std::make_shared<std::set<std::string>>()),
      pages_(new QStackedWidget(this)) {
  WindowSetup setup;
  setup.assets = shell().assets();
  setup.theme = shell().themeKind();
  setup.remember = false;
  setup.embedded = true;
  if (!shell().session().actor().practiceOnly) {
    setup.recording = recording();
  }
  if (const StationDesk::DeviceOpener open = desk.openDevice) {
    setup.openHaptic = [open](const Scene& scene) { return open(scene, scene.pattern.targetAngle_rad); };
  }
  setup.outlet = desk.outlet;
  simulator_ = new SimulatorWindow(setup);
  simulator_->setObjectName(QStringLiteral("simulator"));
  simulator_->setParent(pages_, Qt::Widget);
  pages_->addWidget(simulator_);
  connect(simulator_, &SimulatorWindow::organWanted, this, [this] { bringOrgan().begin(); });
  connect(simulator_, &SimulatorWindow::comparisonWanted, this,
          [this](const SceneRequest& organ) { shell().open(PageId::kCompare, QVariant::fromValue(organ)); });
  auto* column = bareLayout<QVBoxLayout>(this);
  column->addWidget(pages_);
}

OrganWizard& PracticePage::bringOrgan() {
  if (wizard_ == nullptr) {
    wizard_ = new OrganWizard(shell(), pages_);
    pages_->addWidget(wizard_);
    connect(wizard_, &OrganWizard::closed, this, &PracticePage::showSimulator);
    connect(wizard_, &OrganWizard::opened, this, [this](const QString& file) {
      SceneRequest request;
      request.assets = shell().assets();
      request.organFile = toPath(file);
      showSimulator();
      simulator_->controller().load(request);
    });
    wizard_->retranslate();
    wizard_->setTheme(theme(shell().themeKind()));
  }
  simulator_->pause();
  pages_->setCurrentWidget(wizard_);
  return *wizard_;
}

void PracticePage::showSimulator() {
  pages_->setCurrentWidget(simulator_);
  simulator_->resume();
}

PracticePage::~PracticePage() = default;

TrialRecording PracticePage::recording() {
  store_ = std::make_shared<TrialStore>(shell().session().key().locator);
  TrialRecording recording;
  recording.open = [locator = shell().session().key().locator, own = own_](const RecordingSpec& spec) {
    own->insert(spec.trialId);
    return recordingSink(locator, spec.context);
  };
  recording.list = [store = store_, own = own_] {
    std::vector<RecordedTrial> trials;
    for (const TrialListing& trial : store->list()) {
      if (!trial.summary || !own->contains(trial.trialId)) {
        continue;
      }
      trials.push_back({trial.trialId, trial.sceneId, trial.patternId, trial.startedUtc_us,
                        spanOf_s(trial.summary->samples)});
    }
    return trials;
  };
  recording.load = [store = store_](const std::string& id) { return store->load(id); };
  recording.place = store_->location();
  return recording;
}

void PracticePage::enter(const QVariant& argument) {
  if (pages_->currentWidget() == simulator_ || !argument.isNull()) {
    showSimulator();
  }
  if (simulator_->controller().scene() != nullptr && argument.isNull()) {
    return;
  }
  SceneRequest request;
  request.assets = shell().assets();
  request.id = argument.isNull() ? "stomach" : argument.toString().toStdString();
  simulator_->controller().load(request);
}

bool PracticePage::leave() {
  if (simulator_->controller().mode() == SimulationController::Mode::kRecording) {
    shell().notify(tr("A recording is in progress. Stop it first"));
    return false;
  }
  simulator_->pause();
  return true;
}

std::vector<std::pair<QString, QString>> PracticePage::keys() const {
  return PointerKeys::help();
}

void PracticePage::retranslate() {
  simulator_->retranslate();
  if (wizard_ != nullptr) {
    wizard_->retranslate();
  }
}

void PracticePage::applyTheme(const Theme& theme) {
  simulator_->applyColours(theme.kind);
  if (wizard_ != nullptr) {
    wizard_->setTheme(theme);
  }
}

std::vector<ScreenEntry> practiceScreens() {
  return {{.name = QStringLiteral("practice"),
           .role = QStringLiteral("trainee"),
           .pageId = PageId::kPractice,
           .argument = [](SessionContext&) { return QVariant(); },
           .prepare = [](Page& page) { holdAtTarget(child<SimulatorWindow>(page, "simulator")); }},
          {.name = QStringLiteral("practice-engineer"),
           .role = QStringLiteral("trainee"),
           .pageId = PageId::kPractice,
           .argument = [](SessionContext&) { return QVariant(); },
           .prepare =
               [](Page& page) {
                 auto& simulator = child<SimulatorWindow>(page, "simulator");
                 holdAtTarget(simulator);
                 simulator.unfoldEngineerPanel();
               }}};
}

PageEntry practicePage(std::shared_ptr<StationDesk> desk) {
  return {PageId::kPractice, [desk = std::move(desk)](ShellContext& context) -> Page* {
            desk->announce(context.line());
            return new PracticePage(context, *desk);
          }};
}

std::vector<ScreenEntry> organScreens() {
  constexpr double kShown_deg = 45.0;
  return {
      organScreen("organ-source", [](Page& page) { static_cast<PracticePage&>(page).bringOrgan().begin(); }),
      organScreen("organ-slices", &showSlices), organScreen("organ-instrument", &showInstrument),
      organScreen(
          "organ-accepted",
          [](Page& page) { bringStomach(page, QStringLiteral("stomach")).picture().twist(kShown_deg); }),
      organScreen("organ-refused",
                  [](Page& page) { static_cast<void>(bringStomach(page, QStringLiteral("testis"))); })};
}

}  // namespace torsio::gui
