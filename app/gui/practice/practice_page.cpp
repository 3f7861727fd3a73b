// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/practice/practice_page.h"

#include <cstdint>

#include <QCoreApplication>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/organ/organ_wizard.h"
#include "app/gui/simulator/scripted_twist.h"
#include "app/gui/trainee/station_desk.h"
#include "app/gui/widgets/child.h"
#include "app/services/recording/unstored_trials.h"
#include "assessment/attempt/trial_listing.h"
#include "sim/core/time_units.h"

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
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
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
  return SimulatorWindow::pointerKeys();
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

}  // namespace torsio::gui
