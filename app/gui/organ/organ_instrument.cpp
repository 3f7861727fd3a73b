// SPDX-License-Identifier: GPL-3.0-or-later
// The wizard's steps for an instrument: search in a scan or mesh, placement, saving.
#include <utility>

#include <QCheckBox>
#include <QSpinBox>
#include <QStackedWidget>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/organ/instrument_panel.h"
#include "app/gui/organ/organ_wizard.h"
#include "app/gui/widgets/file_choice.h"
#include "sim/imaging/apart/scan_process.h"
#include "sim/imaging/surface/scan_surface.h"
#include "sim/scene/instrument_file.h"
#include "sim/scene/instrument_import.h"

namespace torsio::gui {

void OrganWizard::openInstrument(const std::filesystem::path& source) {
  if (!mayWork()) {
    return;
  }
  ToolRequest tool;
  tool.source = source;
  tool.series = series_->value();
  tool.resample = resample_->isChecked();
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
  if (!file.endsWith(QStringLiteral(".json"))) {
    file += QStringLiteral(".json");
  }
  attempt(shell_, [&] {
    saveInstrument(toPath(file));
    shell_.notify(tr("Saved %1").arg(file));
  });
}

}  // namespace torsio::gui
