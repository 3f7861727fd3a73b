// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/organ/organ_wizard.h"

#include <utility>

#include <QHBoxLayout>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/organ/instrument_panel.h"
#include "app/gui/organ/organ_findings.h"
#include "app/gui/organ/organ_picture.h"
#include "app/gui/organ/organ_settings.h"
#include "app/gui/organ/organ_sources.h"
#include "app/gui/organ/pattern_pictures.h"
#include "app/gui/organ/scan_panel.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/services/organs/person_arm.h"
#include "sim/imaging/apart/scan_process.h"
#include "sim/imaging/surface/scan_surface.h"
#include "sim/scene/instrument_file.h"
#include "sim/scene/instrument_import.h"
#include "sim/scene/organ_file.h"

namespace torsio::gui {

namespace {

constexpr int kSourcePage = 0;
constexpr int kSlicesPage = 1;
constexpr int kJudgingPage = 2;
constexpr int kPanelWidth = 400;
constexpr double kMillimetres = 1000.0;  // in a metre

}  // namespace

OrganWizard::OrganWizard(ShellContext& shell, QWidget* parent)
    : QWidget(parent),
      shell_(shell),
      heading_(new PageHeading(this)),
      pages_(new QStackedWidget(this)),
      close_(new QPushButton(this)),
      sources_(new OrganSources(pages_)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2 * kSpace, 2 * kSpace, 2 * kSpace, 2 * kSpace);
  column->setSpacing(2 * kSpace);
  heading_->addAction(close_);
  column->addWidget(heading_);
  column->addWidget(pages_, 1);
  pages_->addWidget(sources_);
  scan_ = new ScanPanel(pages_);
  pages_->addWidget(scan_);
  pages_->addWidget(createJudgingPage());
  instrument_ = new InstrumentPanel(pages_);
  pages_->addWidget(instrument_);
  connect(close_, &QPushButton::clicked, this, &OrganWizard::closed);
  connect(sources_, &OrganSources::meshChosen, this, &OrganWizard::judgeMesh);
  connect(sources_, &OrganSources::scanChosen, this, &OrganWizard::openScan);
  connect(sources_, &OrganSources::armWanted, this, &OrganWizard::makeArm);
  connect(sources_, &OrganSources::instrumentMeshChosen, this, &OrganWizard::openToolMesh);
  connect(sources_, &OrganSources::instrumentScanChosen, this, &OrganWizard::openInstrument);
  connect(scan_, &ScanPanel::findWanted, this, &OrganWizard::findOrgan);
  connect(scan_, &ScanPanel::surfaceWanted, this, &OrganWizard::makeSurface);
  connect(scan_, &ScanPanel::backWanted, this, &OrganWizard::begin);
  connect(instrument_, &InstrumentPanel::placeWanted, this, &OrganWizard::findInstrument);
  connect(instrument_, &InstrumentPanel::saveWanted, this, &OrganWizard::chooseInstrumentName);
  connect(instrument_, &InstrumentPanel::backWanted, this, &OrganWizard::begin);
  connect(back_, &QPushButton::clicked, this, &OrganWizard::goBack);
  connect(again_, &QPushButton::clicked, this, &OrganWizard::judgeAgain);
  connect(save_, &QPushButton::clicked, this, &OrganWizard::chooseFile);
  connect(open_, &QPushButton::clicked, this, &OrganWizard::openSaved);
  connect(settings_, &OrganSettings::changed, this, &OrganWizard::noteChange);
  connect(picture_, &OrganPicture::picked, settings_, &OrganSettings::takePlace);
  showButtons();
}

QWidget* OrganWizard::createJudgingPage() {
  auto* page = new QWidget(pages_);
  auto* row = bareLayout<QHBoxLayout>(page, 2 * kSpace);
  pictureCard_ = new Card(QString(), page);
  picture_ = new OrganPicture(pictureCard_);
  pictureCard_->content()->addWidget(picture_, 1);
  row->addWidget(pictureCard_, 1);

  auto* side = new QVBoxLayout;
  side->setSpacing(kSpace);
  auto* scroll = new QScrollArea(page);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFixedWidth(kPanelWidth);
  auto* panel = new QWidget;
  auto* column = bareLayout<QVBoxLayout>(panel);
  keepOffScrollBar(*scroll, *column);
  column->setSpacing(2 * kSpace);
  findingsCard_ = new Card(QString(), panel);
  findings_ = new OrganFindings(findingsCard_);
  findingsCard_->content()->addWidget(findings_);
  column->addWidget(findingsCard_);
  patternsCard_ = new Card(QString(), panel);
  patterns_ = new PatternPictures(shell_.assets(), patternsCard_);
  patternsCard_->content()->addWidget(patterns_);
  column->addWidget(patternsCard_);
  settingsCard_ = new Card(QString(), panel);
  settings_ = new OrganSettings(shell_.assets(), settingsCard_);
  settingsCard_->content()->addWidget(settings_);
  column->addWidget(settingsCard_);
  column->addStretch(1);
  scroll->setWidget(panel);
  side->addWidget(scroll, 1);
  back_ = new QPushButton(page);
  again_ = new QPushButton(page);
  save_ = new QPushButton(page);
  open_ = primaryButton(page);
  for (const auto& [left, right] : {std::pair{back_, again_}, {save_, open_}}) {
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(left, 1);
    buttons->addWidget(right, 1);
    side->addLayout(buttons);
  }
  row->addLayout(side);
  return page;
}

const std::filesystem::path& OrganWizard::assets() const {
  return shell_.assets();
}

void OrganWizard::begin() {
  trial_.reset();
  saved_.reset();
  changed_ = false;
  picture_->setTrial({});
  settings_->reset();
  sources_->reset();
  pages_->setCurrentIndex(kSourcePage);
  showButtons();
}

void OrganWizard::goBack() {
  if (!ofScan_) {
    begin();
    return;
  }
  trial_.reset();
  pages_->setCurrentIndex(kSlicesPage);
}

bool OrganWizard::mayWork() {
  if (shell_.working()) {
    shell_.notify(tr("Wait until the current work has finished"));
    return false;
  }
  return true;
}

OrganImportRequest OrganWizard::request() const {
  OrganImportRequest request;
  request.pictures = true;
  request.assets = shell_.assets();
  request.file = source_;
  settings_->apply(request);
  return request;
}

void OrganWizard::judgeMesh(const std::filesystem::path& file) {
  if (!mayWork()) {
    return;
  }
  source_ = file;
  ofScan_ = false;
  ofMeasures_ = false;
  settings_->setMesh(file);
  shell_.run(
      this, tr("Checking the organ"),
      [request = request()](SessionContext&, const ProgressCallback& progress) {
        return trialOfMesh(request, progress);
      },
      [this](OrganTrial trial) { adopt(std::move(trial)); });
}

void OrganWizard::makeArm() {
  if (!mayWork()) {
    return;
  }
  source_ = std::filesystem::path("arm");
  ofScan_ = false;
  ofMeasures_ = true;
  shell_.run(
      this, tr("Drawing the arm"),
      [person = sources_->person(), assets = shell_.assets()](SessionContext&,
                                                              const ProgressCallback& progress) {
        tellProgress(progress, Text::tr("Drawing the arm"), 0.0);
        JudgedArm arm = importArm(person, assets);
        tellProgress(progress, Text::tr("Drawing the organ"), 0.8);
        return std::pair(arm.drawn, trialOf(std::move(arm.import), assets));
      },
      [this](auto drawn) {
        drawnArm_ = std::move(drawn.first);
        adopt(std::move(drawn.second));
      });
}

ScanRequest OrganWizard::ofSource(ScanRequest scan) const {
  scan.source = source_;
  scan.series = sources_->series();
  scan.resample = sources_->resample();
  return scan;
}

void OrganWizard::openScan(const std::filesystem::path& source) {
  if (!mayWork()) {
    return;
  }
  source_ = source;
  ofScan_ = true;
  ofMeasures_ = false;
  settings_->setScan(true);
  shell_.run(
      this, tr("Reading the scan"),
      [scan = ofSource({})](SessionContext&, const ProgressCallback& progress) {
        return previewOf(scan, false, progress);
      },
      [this](ScanPreview preview) { showScan(source_, std::move(preview)); });
}

void OrganWizard::showScan(const std::filesystem::path& source, ScanPreview preview) {
  scan_->setScan(source, std::move(preview));
  pages_->setCurrentIndex(kSlicesPage);
}

void OrganWizard::findOrgan() {
  if (!mayWork()) {
    return;
  }
  shell_.run(
      this, tr("Looking for the organ"),
      [scan = ofSource(scan_->request(false))](SessionContext&, const ProgressCallback& progress) {
        return previewOf(scan, true, progress);
      },
      [this](ScanPreview preview) { scan_->setFound(std::move(preview)); });
}

void OrganWizard::makeSurface() {
  if (!mayWork()) {
    return;
  }
  const OrganImportRequest asked = request();
  drawn_ = ofSource(scan_->request(true));
  if (asked.wall_m) {
    drawn_.wall_mm = kMillimetres * *asked.wall_m;
  }
  shell_.run(
      this, tr("Drawing the organ"),
      [asked, scan = drawn_](SessionContext&, const ProgressCallback& progress) {
        ScanSurface surface;
        OrganTrial trial = trialOfScan(asked, scan, surface, progress);
        return std::pair(std::move(surface), std::move(trial));
      },
      [this](std::pair<ScanSurface, OrganTrial> drawn) {
        surface_ = std::move(drawn.first);
        adopt(std::move(drawn.second));
      });
}

void OrganWizard::judgeAgain() {
  if (!ofScan_) {
    judgeMesh(source_);
    return;
  }
  const OrganImportRequest asked = request();
  const std::optional<double> wall_mm =
      asked.wall_m ? std::optional(kMillimetres * *asked.wall_m) : std::nullopt;
  if (surface_.mesh.triangles.empty() || wall_mm != drawn_.wall_mm) {
    makeSurface();  // another wall needs another surface
    return;
  }
  if (!mayWork()) {
    return;
  }
  shell_.run(
      this, tr("Checking the organ"),
      [asked, scan = drawn_, surface = surface_](SessionContext&, const ProgressCallback& progress) {
        return trialOfSurface(asked, scan, surface, progress);
      },
      [this](OrganTrial trial) { adopt(std::move(trial)); });
}

void OrganWizard::adopt(OrganTrial trial) {
  trial_ = std::move(trial);
  saved_.reset();
  changed_ = false;
  picture_->setTrial(*trial_);
  findings_->show(trial_->import);
  patternsCard_->setVisible(patterns_->show(trial_->import));
  settingsCard_->setVisible(!ofMeasures_);  // nothing to ask about a generated arm
  pages_->setCurrentIndex(kJudgingPage);
  showButtons();
}

void OrganWizard::noteChange() {
  changed_ = true;
  showButtons();
}

void OrganWizard::showButtons() {
  const bool accepted = trial_ && trial_->import.accepted && !changed_;
  again_->setEnabled(trial_ && changed_);
  save_->setEnabled(accepted);
  open_->setEnabled(accepted);
}

void OrganWizard::save(const std::filesystem::path& file) {
  writeOrganFile(file, trial_->import.organ);
  if (ofMeasures_) {
    writeArmMarkers(file, *drawnArm_);
  }
  saved_ = file;
}

bool OrganWizard::chooseFile() {
  // A scan's file name may contain the patient's name.
  const QString name = (ofScan_ ? tr("organ") : toQString(source_.stem())) + QStringLiteral(".organ");
  QString file = askFileToSave(this, tr("Save organ"), name, tr("Organ files (*.organ)"));
  if (file.isEmpty()) {
    return false;
  }
  if (!isOrganFile(toPath(file))) {
    file += QStringLiteral(".organ");
  }
  return attempt(shell_, [&] {
    save(toPath(file));
    shell_.notify(tr("Saved %1").arg(file));
  });
}

void OrganWizard::openSaved() {
  if (saved_ || chooseFile()) {
    Q_EMIT opened(toQString(*saved_));
  }
}

void OrganWizard::retranslate() {
  sources_->retranslate();
  heading_->setTexts({}, tr("Import an organ: once checked, a mesh, a scan or a person's measurements become "
                            "an organ that can be twisted."));
  close_->setText(tr("Back to practice"));
  scan_->retranslate();
  instrument_->retranslate();
  pictureCard_->setTitle(tr("Findings"));
  findingsCard_->setTitle(tr("Check"));
  patternsCard_->setTitle(tr("Patterns"));
  settingsCard_->setTitle(tr("Known details"));
  back_->setText(tr("Back"));
  again_->setText(tr("Check again"));
  again_->setToolTip(tr("With the details as they are now"));
  save_->setText(tr("Save organ\u2026"));
  open_->setText(tr("Open in the simulator"));
  open_->setToolTip(tr("Saves the organ first, so that recordings made on it can be replayed"));
  picture_->retranslate();
  findings_->retranslate();
  patterns_->retranslate();
  settings_->retranslate();
}

void OrganWizard::setTheme(const Theme& theme) {
  picture_->setTheme(theme);
  patterns_->setTheme(theme);
  scan_->setTheme(theme);
  instrument_->setTheme(theme);
}

void OrganWizard::openInstrument(const std::filesystem::path& source) {
  if (!mayWork()) {
    return;
  }
  ToolRequest tool;
  tool.source = source;
  tool.series = sources_->series();
  tool.resample = sources_->resample();
  source_ = source;
  instrument_->begin(tool);
  pages_->setCurrentWidget(instrument_);
  findInstrument();
}

void OrganWizard::openToolMesh(const std::filesystem::path& file) {
  if (!mayWork()) {
    return;
  }
  showToolMesh(file);
  findInstrument();
}

void OrganWizard::showToolMesh(const std::filesystem::path& file) {
  source_ = file;
  instrument_->beginMesh(file);
  pages_->setCurrentWidget(instrument_);
}

void OrganWizard::findInstrument() {
  if (!mayWork()) {
    return;
  }
  const auto show = [this](const ToolSurface& found) { instrument_->setTool(found); };
  if (instrument_->ofMesh()) {
    shell_.run(
        this, tr("Looking for the instrument"),
        [request = instrument_->meshRequest()](SessionContext&, const ProgressCallback& progress) {
          tellProgress(progress, Text::tr("Reading the mesh"), 0.0);
          return importInstrument(request);
        },
        show);
    return;
  }
  shell_.run(
      this, tr("Looking for the instrument"),
      [request = instrument_->request()](SessionContext&, const ProgressCallback& progress) {
        return toolApart(request, [&progress](ScanStep step, double fraction) {
          const ScanStepShare share = shareOf(step);
          tellProgress(progress, share.words, share.at(fraction));
        });
      },
      show);
}

void OrganWizard::saveInstrument(const std::filesystem::path& file) {
  writeInstrument(file, instrument_->tool(), instrument_->facts());
}

void OrganWizard::chooseInstrumentName() {
  QString file = askFileToSave(this, tr("Save instrument"), QStringLiteral("instrument.json"),
                               tr("Instruments (*.json)"));
  if (file.isEmpty()) {
    return;
  }
  if (!file.endsWith(QStringLiteral(".json"), Qt::CaseInsensitive)) {
    file += QStringLiteral(".json");
  }
  attempt(shell_, [&] {
    saveInstrument(toPath(file));
    shell_.notify(tr("Saved %1").arg(file));
  });
}

}  // namespace torsio::gui
