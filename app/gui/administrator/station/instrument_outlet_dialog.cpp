// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/station/instrument_outlet_dialog.h"

#include <chrono>

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTimer>
#include <QVBoxLayout>

#include "app/connectors/tracker/igtl_messages.h"
#include "app/connectors/tracker/instrument_outlet.h"
#include "app/connectors/tracker/tracker_choice.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/form.h"

namespace torsio::gui {

namespace {

constexpr int kOutletDialogWidth_px = 620;
constexpr std::chrono::milliseconds kStateEvery{500};
const QString kOwnComputer = QStringLiteral("127.0.0.1");
const QString kWholeNetwork = QStringLiteral("0.0.0.0");

}  // namespace

InstrumentOutletDialog::InstrumentOutletDialog(ShellContext& shell, QWidget* parent)
    : QDialog(parent),
      shell_(shell),
      on_(named(new QCheckBox(tr("&Offer the instrument of this station (OpenIGTLink)"), this), "outletOn")),
      who_(named(new QComboBox(this), "outletWho")),
      port_(ranged(named(new QSpinBox(this), "outletPort"), 1, 0xffff)),
      caution_(named(sentence(this), "outletCaution")),
      state_(named(sentence(this, false), "outletState")) {
  setObjectName(QStringLiteral("instrumentOutlet"));
  setWindowTitle(tr("Other programs"));
  setMinimumWidth(kOutletDialogWidth_px);
  build();
  read();
}

void InstrumentOutletDialog::build() {
  QLabel* words = sentence(this, false);
  words->setText(
      tr("A program such as 3D Slicer can follow the instrument of this station in runs and free practice: "
         "its pose, and when it touches, grips and releases. The trainee's identity is not sent."));
  port_->setGroupSeparatorShown(false);
  who_->addItem(tr("programs on this computer"), kOwnComputer);
  who_->addItem(tr("all computers of the network"), kWholeNetwork);
  caution_->setText(tr("The data are sent unencrypted and without authentication."));
  auto* form = new QFormLayout;
  form->addRow(tr("&Who may connect"), who_);
  form->addRow(tr("&Port"), port_);
  auto* buttons = new QDialogButtonBox(this);
  QPushButton* keepButton =
      named(buttons->addButton(tr("&Save"), QDialogButtonBox::ActionRole), "outletKeep");
  keepButton->setProperty("primary", true);
  keepButton->setDefault(true);
  buttons->addButton(tr("C&lose"), QDialogButtonBox::RejectRole);
  QVBoxLayout* column = pageColumn(this);
  column->addWidget(words);
  column->addWidget(on_);
  column->addLayout(form);
  column->addWidget(caution_);
  column->addWidget(state_);
  column->addStretch(1);
  column->addWidget(buttons);
  const auto showCaution = [this] {
    who_->setEnabled(on_->isChecked());
    port_->setEnabled(on_->isChecked());
    setLook(caution_, "caution", on_->isChecked() && who_->currentData() != kOwnComputer);
  };
  connect(on_, &QCheckBox::toggled, this, showCaution);
  connect(who_, &QComboBox::currentIndexChanged, this, showCaution);
  connect(keepButton, &QPushButton::clicked, this, &InstrumentOutletDialog::keep);
  connect(buttons, &QDialogButtonBox::rejected, this, &InstrumentOutletDialog::reject);
  auto* clock = new QTimer(this);
  connect(clock, &QTimer::timeout, this, &InstrumentOutletDialog::showState);
  clock->start(kStateEvery);
  showCaution();
}

void InstrumentOutletDialog::read() {
  const TrackerChoice kept = rememberedTracker();
  const QString address = toQString(kept.outletAddress);
  if (who_->findData(address) < 0) {
    who_->addItem(tr("who reaches %1", "an address of this computer").arg(address), address);
  }
  who_->setCurrentIndex(who_->findData(address));
  port_->setValue(kept.outletPort != 0 ? kept.outletPort : kIgtlPort);
  on_->setChecked(kept.outletPort != 0);
  outlet_ = outletOfThisStation();
  showState();
}

void InstrumentOutletDialog::keep() {
  attempt(shell_, [this] {
    TrackerChoice choice = rememberedTracker();
    choice.outletPort = on_->isChecked() ? static_cast<std::uint16_t>(port_->value()) : std::uint16_t{0};
    choice.outletAddress = who_->currentData().toString().toStdString();
    rememberTracker(choice);
    outlet_.reset();
    outlet_ = outletOfThisStation();
    shell_.notify(tr("Saved. It applies at this station from the next sign-in"));
  });
  showState();
}

void InstrumentOutletDialog::showState() {
  const OutletView view = outlet_ != nullptr ? outlet_->view() : OutletView{};
  if (outlet_ == nullptr) {
    state_->setText(tr("Nothing is offered."));
  } else if (!view.trouble.empty()) {
    state_->setText(toQString(view.trouble));
  } else {
    state_->setText(tr("Other programs can connect now. Connected: %1, poses sent: %2")
                        .arg(locale().toString(view.watchers), locale().toString(view.sent)));
  }
  setLook(state_, "caution", outlet_ != nullptr && !view.trouble.empty());
  setLook(state_, "good", view.watchers > 0);
}

}  // namespace torsio::gui
