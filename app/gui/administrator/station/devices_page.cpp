// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/administrator/station/devices_page.h"

#include <algorithm>

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/connectors/built_in.h"
#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/administrator/station/centre_settings_card.h"
#include "app/gui/administrator/station/instrument_outlet_dialog.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/theme.h"
#include "app/services/access/station_name.h"
#include "app/services/devices/haptic_station.h"
#include "app/services/recording/station_writer.h"
#include "sim/device/drivers/device_list.h"

namespace torsio::gui {

DevicesPage::DevicesPage(ShellContext& shell)
    : Page(shell),
      heading_(new PageHeading(this)),
      check_(primaryButton(this)),
      driver_(named(new QComboBox(this), "driver")),
      nameLabel_(nullptr),
      name_(new QLineEdit(this)),
      force_(new QCheckBox(this)),
      others_(named(new QPushButton(this), "otherPrograms")),
      station_(named(sentence(this), "station")),
      verdict_(sentence(this, false)),
      table_(named(new DataTable(QStringLiteral("devices"), this), "findings")),
      settings_(new CentreSettingsCard(shell, this)) {
  heading_->addAction(check_);
  QHBoxLayout* choices = rowOf();
  driverLabel_ = addField(choices, driver_);
  choices->addSpacing(2 * kSpace);
  nameLabel_ = addField(choices, name_);
  name_->setMaximumWidth(280);
  choices->addSpacing(2 * kSpace);
  choices->addWidget(force_);
  choices->addStretch(1);
  choices->addWidget(others_);
  QVBoxLayout* column = pageColumn(this);
  column->addWidget(heading_);
  column->addWidget(station_);
  column->addLayout(choices);
  column->addWidget(verdict_);
  column->addWidget(table_, 1);
  column->addWidget(settings_);
  driver_->addItem(QString(), QString());
  for (const DeviceDriver& driver : deviceDrivers()) {
    if (driver.use == DriverUse::kStation) {
      driver_->addItem(toQString(driver.name), toQString(driver.id));
    }
  }
  connect(driver_, &QComboBox::activated, this, &DevicesPage::remember);
  connect(name_, &QLineEdit::editingFinished, this, &DevicesPage::remember);
  connect(check_, &QPushButton::clicked, this, &DevicesPage::check);
  others_->setVisible(kTrackerBuiltIn);
  if constexpr (kTrackerBuiltIn) {
    connect(others_, &QPushButton::clicked, this, [this] {
      auto* dialog = new InstrumentOutletDialog(this->shell(), this);
      dialog->setAttribute(Qt::WA_DeleteOnClose);
      dialog->open();
    });
  }
  retranslate();
}

void DevicesPage::enter(const QVariant&) {
  settings_->read();
  const DeviceChoice kept = rememberedDevice();
  driver_->setCurrentIndex(std::max(0, driver_->findData(toQString(kept.driver))));
  name_->setText(toQString(kept.name));
  showContent();
}

DeviceChoice DevicesPage::choice() const {
  return {.driver = driver_->currentData().toString().toStdString(),
          .name = name_->text().trimmed().toStdString()};
}

void DevicesPage::remember() {
  const DeviceChoice now = choice();
  const DeviceChoice kept = rememberedDevice();
  if (now.driver == kept.driver && now.name == kept.name) {
    return;
  }
  attempt(shell(), [&] {
    rememberDevice(now);
    shell().notify(tr("Saved. It applies at this station from the next sign-in"));
  });
}

void DevicesPage::check() {
  DeviceCheckRequest request;
  request.choice = choice();
  request.forceTest = force_->isChecked();
  request.buttons = request.forceTest;  // somebody holds the stylus
  check_->setEnabled(false);
  shell().run(
      this, tr("Checking the device"),
      [request](SessionContext&, const ProgressCallback& progress) mutable {
        request.say = [&progress](const Text& sentence) { progress({sentence, 0.5, -1.0}); };
        progress({Text::tr("Looking for the device"), 0.1, -1.0});
        return checkDevice(request);
      },
      [this](DeviceCheckResult result) {
        result_ = std::move(result);
        if (StationWriter* line = shell().line(); line != nullptr) {
          line->showDevice(stationDevice(hapticReadiness(*result_), shell().session().now_us()));
        }
        showContent();
      });
  check_->setEnabled(true);
}

void DevicesPage::showContent() {
  std::vector<Row> rows;
  if (result_) {
    for (const DeviceFinding& finding : result_->findings) {
      // Symbol and word: never colour alone.
      const QString grade = finding.grade == FindingGrade::kGood   ? tr("\u2713 good")
                            : finding.grade == FindingGrade::kNote ? tr("! note")
                                                                   : tr("\u2717 not usable");
      rows.push_back({toQString(finding.subject),
                      {{grade, static_cast<int>(finding.grade)},
                       {toQString(Text(finding.subject))},
                       {toQString(finding.sentence)},
                       {finding.remedy.empty() ? orDash({}) : toQString(finding.remedy)}}});
    }
  }
  table_->setRows(std::move(rows));
  if (!result_) {
    verdict_->setText(
        tr("Not checked yet in this session. The check takes a few seconds; put the stylus into the inkwell "
           "first."));
  } else if (result_->usable()) {
    verdict_->setText(result_->capabilities.rendersForce
                          ? tr("This station can do graded runs with the device: %1 servo ticks a second.")
                                .arg(locale().toString(result_->rate_Hz, 'f', 0))
                          : tr("The device works. It gives no force: runs with it are graded only where the "
                               "centre grades with the mouse."));
  } else {
    verdict_->setText(tr("No graded run with the device now: %1. Practice with the mouse works meanwhile.")
                          .arg(toQString(result_->worst()->sentence)));
  }
  setLook(verdict_, "caution", result_ && !result_->usable());
  setLook(verdict_, "good", result_ && result_->usable());
}

void DevicesPage::retranslate() {
  settings_->retranslate();
  heading_->setTexts(tr("Devices"), tr("Whether the haptic device of this station is fit for a graded run."));
  const StationSign sign = stationSign();
  station_->setText(tr("This station records as %1, on the computer %2.")
                        .arg(toQString(sign.name), toQString(sign.computer)));
  station_->setToolTip(
      tr("Made once and kept when the computer is renamed, in %1").arg(toQString(sign.settings)));
  check_->setText(tr("&Check the device"));
  driverLabel_->setText(tr("This station w&orks with"));
  driver_->setItemText(0, tr("the first device found"));
  nameLabel_->setText(tr("De&vice name"));
  name_->setPlaceholderText(tr("default"));
  others_->setText(tr("Other &programs\u2026"));
  force_->setText(tr("&Force test: someone must hold the stylus"));
  table_->setColumns({{tr("Result")}, {tr("Checked")}, {tr("Findings")}, {tr("What to do")}});
  table_->setEmptyText(
      tr("Press \u201c"
         "Check the device\u201d."));
  showContent();
}

}  // namespace torsio::gui
