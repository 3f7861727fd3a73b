// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/station/centre_settings_card.h"

#include <algorithm>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "app/connectors/built_in.h"
#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/administrator/station/learning_records_dialog.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/field_checks.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/services/access/centre_settings.h"
#include "app/services/access/first_run.h"
#include "app/services/access/two_people.h"
#include "sim/core/time_units.h"

namespace torsio::gui {

namespace {

/// Sets a field's range to that of its setting.
void bound(auto* box, const CentreSetting& setting) {
  using Value = decltype(box->value());
  box->setRange(static_cast<Value>(setting.least), static_cast<Value>(setting.most));
}

}  // namespace

CentreSettingsCard::CentreSettingsCard(ShellContext& shell, QWidget* parent)
    : Card(QString(), parent),
      shell_(shell),
      nameLabel_(nullptr),
      name_(named(new QLineEdit(this), "centreName")),
      warn_(named(new QSpinBox(this), "idleWarn")),
      lock_(named(new QSpinBox(this), "idleLock")),
      mouse_(named(new QCheckBox(this), "gradedWithMouse")),
      sound_(named(new QCheckBox(this), "soundAtLimit")),
      panel_(named(new QCheckBox(this), "panelWaits")),
      two_(named(new QCheckBox(this), "twoPeople")),
      cards_(named(new QCheckBox(this), "kioskCodes")),
      factor_(named(new QComboBox(this), "secondFactor")),
      sign_(named(new QSpinBox(this), "signMinutes")),
      watched_(named(new QDoubleSpinBox(this), "minimumWatched")),
      speeds_(named(new QLineEdit(this), "playbackSpeeds")),
      apart_(named(new QDoubleSpinBox(this), "discrepancyPoints")),
      note_(sentence(this)),
      learning_(named(new QPushButton(this), "learningRecordsButton")),
      keep_(named(new QPushButton(this), "keepSettings")),
      checks_(new FieldChecks(this)) {
  bound(sign_, kSignMinutes);
  bound(lock_, kIdleLock_min);
  bound(warn_, kIdleWarn_min);
  bound(watched_, kMinimumWatched_percent);
  bound(apart_, kDiscrepancy_points);
  watched_->setDecimals(0);
  apart_->setDecimals(1);
  apart_->setSingleStep(0.5);
  QHBoxLayout* row = rowOf();
  nameLabel_ = addField(row, name_);
  row->setStretchFactor(name_, 1);
  row->addSpacing(2 * kSpace);
  warnLabel_ = addField(row, warn_);
  row->addSpacing(2 * kSpace);
  lockLabel_ = addField(row, lock_);
  content()->addLayout(row);
  checks_->add(content(), name_, [this] {
    return name_->text().trimmed().isEmpty() ? tr("Enter the name of your centre.") : QString();
  });
  checks_->decide(keep_);
  QHBoxLayout* scoring = rowOf();
  watchedLabel_ = addField(scoring, watched_);
  scoring->addSpacing(2 * kSpace);
  speedsLabel_ = addField(scoring, speeds_);
  scoring->addSpacing(2 * kSpace);
  apartLabel_ = addField(scoring, apart_);
  scoring->addStretch(1);
  content()->addLayout(scoring);
  checks_->add(content(), speeds_, [this] {
    return validCentreSetting(kPlaybackSpeeds, speeds_->text().remove(QLatin1Char(' ')).toStdString())
               ? QString()
               : tr("Write speeds from 0.1 to 4, with commas between: 0.5, 1, 1.5. 1 is as recorded.");
  });
  content()->addWidget(panel_);
  content()->addWidget(mouse_);
  content()->addWidget(sound_);
  content()->addWidget(two_);
  content()->addWidget(cards_);
  for (const std::string& asked : choicesOf(kSecondFactor)) {
    factor_->addItem(QString(), toQString(asked));
  }
  QHBoxLayout* signing = rowOf();
  signLabel_ = addField(signing, sign_);
  signing->addSpacing(2 * kSpace);
  factorLabel_ = addField(signing, factor_);
  signing->addStretch(1);
  signing->addWidget(learning_);
  signing->addWidget(keep_);
  content()->addLayout(signing);
  content()->addWidget(note_);
  // The field edited last wins; the other one is adjusted.
  connect(lock_, &QSpinBox::editingFinished, this,
          [this] { warn_->setValue(std::min(warn_->value(), lock_->value() - 1)); });
  connect(warn_, &QSpinBox::editingFinished, this,
          [this] { lock_->setValue(std::max(lock_->value(), warn_->value() + 1)); });
  learning_->setVisible(kXapiBuiltIn);
  if constexpr (kXapiBuiltIn) {
    connect(learning_, &QPushButton::clicked, this, [this] { LearningRecordsDialog(shell_, this).exec(); });
  }
  connect(keep_, &QPushButton::clicked, this, &CentreSettingsCard::keep);
  retranslate();
}

void CentreSettingsCard::read() {
  attempt(shell_, [this] {
    Connection& connection = shell_.session().connectionWithoutRight();
    name_->setText(toQString(centreSign(connection).name));
    const IdleLimits limits = centreIdleLimits(connection);
    lock_->setValue(static_cast<int>(limits.lock_us / kMinute_us));
    warn_->setValue(static_cast<int>(limits.warn_us / kMinute_us));
    panel_->setChecked(centreSetting<kPanelWaits>(connection));
    mouse_->setChecked(centreSetting<kGradedWithMouse>(connection));
    sound_->setChecked(centreSetting<kSoundAtLimit>(connection));
    two_->setChecked(centreSetting<kTwoPeople>(connection));
    cards_->setChecked(centreSetting<kKioskCodes>(connection));
    sign_->setValue(centreSetting<kSignMinutes>(connection));
    factor_->setCurrentIndex(factor_->findData(toQString(centreSetting<kSecondFactor>(connection))));
    watched_->setValue(centreSetting<kMinimumWatched_percent>(connection));
    apart_->setValue(centreSetting<kDiscrepancy_points>(connection));
    QString speeds = toQString(asStored(kPlaybackSpeeds, centreSetting<kPlaybackSpeeds>(connection)));
    speeds_->setText(speeds.replace(QLatin1Char(','), QStringLiteral(", ")));
  });
}

void CentreSettingsCard::keep() {
  attempt(shell_, [this] {
    SessionContext& session = shell_.session();
    setCentreName(session, name_->text().trimmed().toStdString());
    setCentreIdleLimits(session, warn_->value(), lock_->value());
    setCentreSetting<kMinimumWatched_percent>(session, watched_->value());
    changeCentreSetting(session, kPlaybackSpeeds, speeds_->text().remove(QLatin1Char(' ')).toStdString());
    setCentreSetting<kDiscrepancy_points>(session, apart_->value());
    setCentreSetting<kPanelWaits>(session, panel_->isChecked());
    setCentreSetting<kGradedWithMouse>(session, mouse_->isChecked());
    setCentreSetting<kSoundAtLimit>(session, sound_->isChecked());
    setCentreSetting<kSignMinutes>(session, sign_->value());
    setCentreSetting<kKioskCodes>(session, cards_->isChecked());
    setCentreSetting<kSecondFactor>(session, factor_->currentData().toString().toStdString());
    if (two_->isChecked() != needsTwoPeople(shell_.session().connectionWithoutRight())) {
      keepTwoPeople();
    }
    shell_.notify(tr("Saved. It applies at every station from the next sign-in"));
  });
}

void CentreSettingsCard::keepTwoPeople() {
  const bool two = two_->isChecked();
  const DutyWish wish{.act = DutyAct::kOnePerson,
                      .subject = std::string(kTwoPeople.name),
                      .reason = "one person is to be enough"};
  actOrAsk(this, shell_, wish, [&] { setCentreSetting<kTwoPeople>(shell_.session(), two); });
  two_->setChecked(needsTwoPeople(shell_.session().connectionWithoutRight()));
}

void CentreSettingsCard::retranslate() {
  setTitle(tr("At every station"));
  nameField(nameLabel_, tr("&Name of the centre"));
  nameField(warnLabel_, tr("When idle, &warn after"));
  nameField(lockLabel_, tr("and &lock after"));
  warn_->setSuffix(tr(" min"));
  lock_->setSuffix(tr(" min"));
  panel_->setText(tr("Raters see the panel's marks only after all their own sheets of the occasion"));
  mouse_->setText(tr("&Grade runs with mouse and keyboard"));
  sound_->setText(tr("Play a sound when a l&imit is reached (not in a shared room)"));
  two_->setText(
      tr("&Two people for new passwords and roles of those who score or run the study, for erasing, "
         "restoring and opening the allocation"));
  cards_->setText(
      tr("&Kiosks admit trainees by the code on their card, without a password (from their next start)"));
  nameField(watchedLabel_, tr("Raters &must watch"));
  nameField(speedsLabel_, tr("of a recording, at spee&ds"));
  nameField(apartLabel_, tr("Discrepanc&y review from"));
  watched_->setSuffix(tr(" %"));
  apart_->setSuffix(tr(" points"));
  nameField(signLabel_, tr("One password &entry signs for"));
  sign_->setSuffix(tr(" min"));
  sign_->setSpecialValueText(tr("one signature"));
  nameField(factorLabel_, tr("Second f&actor asked of"));
  const QStringList asked{tr("nobody"), tr("administrators"), tr("everybody")};  // as choicesOf()
  for (int i = 0; i < factor_->count(); ++i) {
    factor_->setItemText(i, asked.value(i));
  }
  note_->setText(tr("This never interrupts a run. A kiosk signs out instead of locking."));
  learning_->setText(tr("Learning &records\u2026"));
  keep_->setText(tr("&Save"));
}

}  // namespace torsio::gui
