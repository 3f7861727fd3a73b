// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/trainee/device_check_page.h"

#include <utility>

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/trainee/station_desk.h"
#include "app/gui/trainee/station_parts.h"
#include "app/gui/trainee/trainee_labels.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/services/devices/haptic_station.h"
#include "app/services/recording/station_writer.h"
#include "app/services/training/run_session.h"

namespace torsio::gui {

namespace {

constexpr int kCheckWidest = 860;

const char* iconOf(Light light) {
  return light == Light::kGreen ? "check" : light == Light::kAmber ? "warning" : "stop";
}

QColor colourOf(Light light, const Theme& theme) {
  return light == Light::kGreen ? theme.good : light == Light::kAmber ? theme.caution : theme.recording;
}

}  // namespace

DeviceCheckPage::DeviceCheckPage(ShellContext& context, StationDesk& desk, QWidget* parent)
    : Page(context, parent), desk_(desk), theme_(&theme(context.themeKind())) {
  const PageColumn page = pageColumn(this, kCheckWidest);
  heading_ = page.heading;
  card_ = new Card(QString(), this);
  verdict_ = named(plainLabel(card_, "heading"), "verdict");
  meaning_ = plainLabel(card_, "quiet");
  card_->content()->addWidget(verdict_);
  card_->content()->addWidget(meaning_);
  findings_ = new QVBoxLayout;
  findings_->setSpacing(kSpace);
  card_->content()->addSpacing(kSpace);
  card_->content()->addLayout(findings_);
  page.column->addWidget(card_);
  again_ = new QPushButton(this);
  mouse_ = new QPushButton(this);
  practise_ = named(new QPushButton(this), "practise");
  goOn_ = named(primaryButton(this), "goOn");
  auto* row = new QHBoxLayout;
  row->addWidget(again_);
  row->addStretch(1);
  row->addWidget(mouse_);
  row->addWidget(practise_);
  row->addWidget(goOn_);
  page.column->addLayout(row);
  page.column->addStretch(1);
  connect(again_, &QPushButton::clicked, this, &DeviceCheckPage::check);
  connect(goOn_, &QPushButton::clicked, this, [this] { goOn(desk_.graded); });
  connect(practise_, &QPushButton::clicked, this, [this] { goOn(false); });
  connect(mouse_, &QPushButton::clicked, this, [this] {
    desk_.openDevice = nullptr;
    // The board still shows the unfit device.
    desk_.readiness = pointerReadiness(gradesWithMouse(shell().session()));
    goOn(false);
  });
}

void DeviceCheckPage::enter(const QVariant&) {
  check();
}

void DeviceCheckPage::check() {
  desk_.readiness.reset();
  if (!desk_.probe) {
    attempt(shell(), [&] { found(pointerReadiness(gradesWithMouse(shell().session()))); });
    fill();
    return;
  }
  checking_ = true;
  fill();
  shell().run(
      this, tr("Checking the device"),
      [probe = desk_.probe](SessionContext&, const ProgressCallback&) { return probe(); },
      [this](const DeviceReadiness& readiness) {
        checking_ = false;
        attempt(shell(), [&] { found(judgedByForce(readiness, gradesWithMouse(shell().session()))); });
        fill();
      });
}

void DeviceCheckPage::found(const DeviceReadiness& readiness) {
  desk_.readiness = readiness;
  if (StationWriter* line = shell().line(); line != nullptr) {
    line->showDevice(stationDevice(readiness, shell().session().now_us()));
  }
}

void DeviceCheckPage::goOn(bool graded) {
  desk_.graded = graded;
  if (!desk_.chosen) {
    shell().open(PageId::kNextStep);
    return;
  }
  shell().open(desk_.moduleId.empty() ? PageId::kRun : PageId::kBriefing);
}

void DeviceCheckPage::retranslate() {
  fill();
}

void DeviceCheckPage::applyTheme(const Theme& theme) {
  theme_ = &theme;
  fill();
}

void DeviceCheckPage::fill() {
  const bool known = desk_.readiness.has_value();
  heading_->setTexts(tr("Is everything ready?"),
                     known && !desk_.readiness->haptic && !desk_.probe
                         ? tr("This station has no haptic device: you work with mouse and keyboard.")
                     : known && !desk_.readiness->haptic
                         ? tr("Sit down and take the device into your hand.")
                         : tr("Sit down, put the stylus into its dock, and rest your forearm."));
  again_->setText(tr("Check &again"));
  mouse_->setText(tr("Practise with the &mouse"));
  practise_->setText(tr("&Practise"));
  goOn_->setText(desk_.graded ? tr("&Continue to the graded run") : tr("&Continue"));
  emptyLayout(findings_);
  const Light light = known ? desk_.readiness->light() : Light::kRed;
  card_->setTitle(known ? toQString(desk_.readiness->device) : tr("Device"));
  verdict_->setText(checking_ ? tr("Checking\u2026") : StationLabels::light(light));
  meaning_->setText(checking_ ? tr("This takes a few seconds.")
                    : light == Light::kGreen
                        ? tr("Everything is in order. Practice and graded runs may begin.")
                    : light == Light::kAmber
                        ? tr("Good enough to practise. A graded run needs every line to be in order.")
                        : tr("There is a problem. Graded runs are not possible with this device now."));
  again_->setEnabled(!checking_);
  mouse_->setVisible(!checking_ && light == Light::kRed);
  practise_->setVisible(desk_.graded && light == Light::kAmber);
  goOn_->setEnabled(!checking_ && (light == Light::kGreen || (light == Light::kAmber && !desk_.graded)));
  // Enter continues with what is possible.
  if (goOn_->isEnabled()) {
    goOn_->setFocus();
  } else if (!practise_->isHidden()) {
    practise_->setFocus();
  }
  if (!known) {
    return;
  }
  for (const ReadinessFinding& finding : desk_.readiness->findings) {
    QHBoxLayout* row = rowOf({}, kSpace + 4);
    auto* mark = new QLabel(card_);
    showIcon(mark, QLatin1String(iconOf(finding.light)), colourOf(finding.light, *theme_));
    mark->setAccessibleName(StationLabels::light(finding.light));
    row->addWidget(mark, 0, Qt::AlignTop);
    auto* texts = new QVBoxLayout;
    texts->setSpacing(2);
    auto* what = plainLabel(card_);
    what->setText(finding.detail.empty()
                      ? StationLabels::readiness(finding)
                      : tr("%1: %2").arg(StationLabels::readiness(finding), toQString(finding.detail)));
    texts->addWidget(what);
    if (!finding.remedy.empty()) {
      auto* remedy = plainLabel(card_, "quiet");
      remedy->setText(toQString(finding.remedy));
      texts->addWidget(remedy);
    }
    row->addLayout(texts, 1);
    findings_->addLayout(row);
  }
}

}  // namespace torsio::gui
