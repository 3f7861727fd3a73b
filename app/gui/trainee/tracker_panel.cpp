// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/tracker_panel.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "app/connectors/tracker/tracker_choice.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "sim/core/angle.h"

namespace torsio::gui {

namespace {

constexpr double kMillimetresPerMetre = 1e3;

/// Returns the instrument's rotation against its tracker's reference.
double turnOf_deg(const Quat& orientation) {
  return degrees(2.0 * std::acos(std::clamp(std::abs(orientation.w), 0.0, 1.0)));
}

}  // namespace

TrackerPanel::TrackerPanel(ShellContext& shell, QWidget* parent)
    : Card(QString(), parent),
      shell_(shell),
      address_(named(new QLineEdit(this), "trackerAddress")),
      port_(ranged(named(new QSpinBox(this), "trackerPort"), 1, 0xffff)),
      instrument_(named(new QLineEdit(this), "trackerInstrument")),
      listens_(named(new QCheckBox(this), "trackerListens")),
      connect_(named(new QPushButton(this), "trackerConnect")),
      status_(named(sentence(this, false), "trackerStatus")),
      pose_(named(sentence(this), "trackerPose")),
      counts_(named(sentence(this), "trackerCounts")) {
  port_->setGroupSeparatorShown(false);
  QHBoxLayout* row = rowOf();
  addressLabel_ = addField(row, address_);
  portLabel_ = addField(row, port_);
  instrumentLabel_ = addField(row, instrument_);
  row->setStretchFactor(instrument_, 1);
  content()->addLayout(row);
  QHBoxLayout* second = rowOf();
  second->addWidget(listens_, 1);
  second->addWidget(connect_);
  content()->addLayout(second);
  for (QLabel* label : {status_, pose_, counts_}) {
    content()->addWidget(label);
  }
  QObject::connect(connect_, &QPushButton::clicked, this, &TrackerPanel::toggle);
  showPlace({});
  retranslate();
}

void TrackerPanel::showPlace(const TrackerPlace& place) {
  address_->setText(toQString(place.address));
  port_->setValue(place.port);
  instrument_->setText(toQString(place.instrument));
  listens_->setChecked(place.listens);
}

TrackerPlace TrackerPanel::shownPlace() const {
  return {.address = address_->text().trimmed().toStdString(),
          .port = static_cast<std::uint16_t>(port_->value()),
          .listens = listens_->isChecked(),
          .instrument = instrument_->text().trimmed().toStdString()};
}

void TrackerPanel::begin(const std::optional<TrackerPlace>& place) {
  if (place && link_ == nullptr) {
    showPlace(*place);
    link_ = std::make_unique<TrackerLink>(*place);
  }
  showLink(false);
}

void TrackerPanel::toggle() {
  if (link_ != nullptr) {
    Q_EMIT lettingGo();
    link_.reset();
    showLink(false);
    return;
  }
  attempt(shell_, [this] {
    TrackerChoice choice = rememberedTracker();
    choice.tracker = shownPlace();
    rememberTracker(choice);
    link_ = std::make_unique<TrackerLink>(*choice.tracker);
  });
  showLink(false);
}

void TrackerPanel::follow(bool recording) {
  showLink(recording);
}

void TrackerPanel::showLink(bool recording) {
  recording_ = recording;
  const bool connected = link_ != nullptr;
  for (QWidget* field : {static_cast<QWidget*>(address_), static_cast<QWidget*>(port_),
                         static_cast<QWidget*>(instrument_), static_cast<QWidget*>(listens_)}) {
    field->setEnabled(!connected);
  }
  connect_->setText(connected ? tr("&Disconnect") : tr("&Connect"));
  const TrackerView view = connected ? link_->view() : TrackerView{};
  const bool posed = connected && view.counts.received > 0;
  pose_->setVisible(posed);
  counts_->setVisible(posed);
  QString said = tr("No tracker: where the instrument is, is not recorded.");
  if (connected) {
    switch (view.stage) {
      case TrackerStage::kSeeking:
        said = link_->place().listens ? tr("Waiting for the tracker to call.") : tr("Calling the tracker.");
        break;
      case TrackerStage::kWaiting:
        said = tr("Connected. No pose of the instrument has come yet.");
        break;
      case TrackerStage::kTracking:
        said = recording ? tr("The instrument is seen, and recorded.") : tr("The instrument is seen.");
        break;
      case TrackerStage::kSilent:
        said = tr("The instrument is not seen. Turn it towards the tracker.");
        break;
    }
    if (!view.trouble.empty()) {
      said = tr("%1 Last trouble: %2.", "a sentence, and what the tracker or the network said")
                 .arg(said, toQString(view.trouble));
    }
  }
  status_->setText(said);
  setLook(status_, "caution", connected && view.stage != TrackerStage::kTracking);
  if (!posed) {
    return;
  }
  const Vec3 mm = view.pose.position_m * kMillimetresPerMetre;
  pose_->setText(tr("%1: %2, %3, %4 mm, turned by %5\302\260")
                     .arg(toQString(view.instrument), numberText(mm.x, 1), numberText(mm.y, 1),
                          numberText(mm.z, 1), numberText(turnOf_deg(view.pose.orientation), 0)));
  const QString missing = view.stamped ? QString::number(view.counts.missing) : tr("not known");
  counts_->setText(tr("Poses: %1, missing: %2, late: %3, of no use: %4; %5 a second")
                       .arg(QString::number(view.counts.received), missing, QString::number(view.counts.late),
                            QString::number(view.counts.refused), QString::number(view.rate_per_s, 'f', 1)));
}

void TrackerPanel::retranslate() {
  setTitle(tr("Tracker on the instrument"));
  nameField(addressLabel_, tr("&Address"));
  nameField(portLabel_, tr("&Port"));
  nameField(instrumentLabel_, tr("&Instrument"));
  instrument_->setPlaceholderText(tr("the first that comes"));
  listens_->setText(tr("&Wait for the tracker to call"));
  showLink(recording_);
}

}  // namespace torsio::gui
