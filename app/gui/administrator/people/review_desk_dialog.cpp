// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/people/review_desk_dialog.h"

#include <exception>
#include <utility>

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/services/access/station_record.h"
#include "sim/core/error.h"

namespace torsio::gui {

namespace {

constexpr QSize kReviewDeskSize(720, 560);
constexpr int kLowestPort = 1024;  // lower ports are reserved for the system
constexpr int kHighestPort = 65535;
constexpr int kDefaultPort = 8443;

enum Reach { kOtherMachines, kThisMachine };
enum CertificateChoice { kOwnCertificate, kCertificateFiles };

QHBoxLayout* fieldWithButton(QLineEdit* field, QPushButton* button) {
  auto* row = new QHBoxLayout;
  row->addWidget(field, 1);
  row->addWidget(button);
  button->setAutoDefault(false);
  return row;
}

}  // namespace

DeskPlace ReviewDeskDialog::ownPlace() {
  return {toPath(QCoreApplication::applicationFilePath()), dataFolder() / "review-desk"};
}

ReviewDeskDialog::ReviewDeskDialog(ShellContext& shell, DeskPlace place, QWidget* parent)
    : QDialog(parent),
      shell_(shell),
      place_(std::move(place)),
      state_(named(sentence(this, false), "deskState")),
      openPart_(new QWidget(this)),
      address_(named(new QComboBox(openPart_), "deskAddress")),
      copy_(new QPushButton(tr("&Copy"), openPart_)),
      trust_(named(sentence(openPart_), "deskTrust")),
      choices_(new QWidget(this)),
      reach_(named(new QComboBox(choices_), "deskReach")),
      port_(ranged(named(new QSpinBox(choices_), "deskPort"), kLowestPort, kHighestPort)),
      certificate_(named(new QComboBox(choices_), "deskCertificate")),
      files_(new QWidget(choices_)),
      certificateFile_(named(new QLineEdit(files_), "certificateFile")),
      keyFile_(named(new QLineEdit(files_), "keyFile")),
      goesOn_(named(new QCheckBox(tr("&Stays open when Torsio is closed here"), choices_), "deskGoesOn")),
      said_(named(sentence(this, false), "deskSaid")),
      act_(named(primaryButton(this), "deskAct")) {
  setObjectName(QStringLiteral("reviewDesk"));
  setWindowTitle(tr("Let physicians score from their browsers"));
  resize(kReviewDeskSize);
  build();
  read();
}

void ReviewDeskDialog::build() {
  QLabel* words = sentence(this);
  words->setText(tr(
      "Physicians open the address in any browser in the hospital and score the same cases as at the desk; "
      "nothing is installed. Each needs an account, and signs in with an invitation (Users, Invite) or a "
      "password. This computer must stay on."));
  address_->setAccessibleName(tr("Address"));
  trust_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  QVBoxLayout* shown = columnOf(openPart_, {});
  auto* row = new QHBoxLayout;
  row->addWidget(address_, 1);
  row->addWidget(copy_);
  copy_->setAutoDefault(false);
  shown->addLayout(row);
  shown->addWidget(trust_);
  reach_->addItems({tr("Other computers of this network"), tr("This computer alone")});
  port_->setValue(kDefaultPort);
  certificate_->addItems({tr("Made by Torsio"), tr("From files")});
  auto* form = new QFormLayout;
  form->addRow(tr("&Who can reach it"), reach_);
  form->addRow(tr("&Port"), port_);
  form->addRow(tr("C&ertificate"), certificate_);
  auto* fileForm = new QFormLayout(files_);
  fileForm->setContentsMargins({});
  for (const auto& [field, name, button] :
       {std::tuple{certificateFile_, tr("Certificate with its chain (PEM)"), tr("C&hoose\u2026")},
        {keyFile_, tr("Its key (PEM)"), tr("Choose &key\u2026")}}) {
    auto* choose = new QPushButton(button, files_);
    field->setAccessibleName(name);
    fileForm->addRow(name, fieldWithButton(field, choose));
    connect(choose, &QPushButton::clicked, this,
            [this, field = field, name = name] { chooseFile(field, name); });
  }
  QVBoxLayout* column = columnOf(choices_, {});
  column->addLayout(form);
  column->addWidget(files_);
  column->addWidget(goesOn_);
  auto* buttons = new QDialogButtonBox(this);
  act_->setDefault(true);
  buttons->addButton(act_, QDialogButtonBox::ActionRole);
  buttons->addButton(tr("&Done"), QDialogButtonBox::RejectRole)->setAutoDefault(false);
  QVBoxLayout* whole = pageColumn(this);
  whole->setSpacing(kSpace);
  for (QWidget* part : {static_cast<QWidget*>(words), static_cast<QWidget*>(state_), openPart_, choices_,
                        static_cast<QWidget*>(said_)}) {
    whole->addWidget(part);
  }
  whole->addStretch(1);
  whole->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &ReviewDeskDialog::reject);
  connect(act_, &QPushButton::clicked, this, [this] { open_ ? closeDesk() : openDesk(); });
  connect(copy_, &QPushButton::clicked, this, &ReviewDeskDialog::copyAddress);
  connect(reach_, &QComboBox::currentIndexChanged, this, &ReviewDeskDialog::showChoices);
  connect(certificate_, &QComboBox::currentIndexChanged, this, &ReviewDeskDialog::showChoices);
}

void ReviewDeskDialog::read() {
  attempt(shell_, [this] {
    if (!mayOpenReviewDesk(shell_.session())) {
      state_->setText(
          tr("This record is on a server. The server's administrator opens the review desk there with torsio "
             "serve, not this window."));
      openPart_->hide();
      choices_->hide();
      act_->hide();
      return;
    }
    const std::optional<OpenReviewDesk> desk = openReviewDesk(shell_.session(), place_);
    open_ = desk.has_value();
    state_->setText(!open_         ? tr("The review desk is closed.")
                    : desk->goesOn ? tr("The review desk is open, and stays open when Torsio is closed here.")
                                   : tr("The review desk is open, and closes with this window."));
    setLook(state_, "good", open_);
    address_->clear();
    for (const std::string& address : open_ ? desk->addresses : std::vector<std::string>()) {
      address_->addItem(toQString(address));
    }
    trust_->setText(open_ && !desk->fingerprint.empty() ? tr("A browser that does not know the certificate "
                                                             "asks once whether to trust it. It is the right "
                                                             "one when its SHA-256 fingerprint is:\n%1")
                                                              .arg(toQString(desk->fingerprint))
                                                        : QString());
    trust_->setVisible(!trust_->text().isEmpty());
    openPart_->setVisible(open_);
    choices_->setVisible(!open_);
    copy_->setText(tr("&Copy"));
    act_->setText(open_ ? tr("C&lose the review desk") : tr("&Open the review desk"));
    act_->setEnabled(!working_);
    showChoices();
  });
}

void ReviewDeskDialog::showChoices() {
  const bool others = reach_->currentIndex() == kOtherMachines;
  certificate_->setEnabled(others);
  files_->setVisible(others && certificate_->currentIndex() == kCertificateFiles);
}

DeskWish ReviewDeskDialog::wish() const {
  DeskWish wish{.otherMachines = reach_->currentIndex() == kOtherMachines,
                .port = static_cast<std::uint16_t>(port_->value())};
  if (wish.otherMachines && certificate_->currentIndex() == kCertificateFiles) {
    wish.certificate = toPath(certificateFile_->text().trimmed());
    wish.key = toPath(keyFile_->text().trimmed());
  }
  wish.goesOn = goesOn_->isChecked();
  return wish;
}

void ReviewDeskDialog::openDesk() {
  act(tr("Opening the review desk"),
      [wish = wish(), place = place_](SessionContext& session) { startReviewDesk(session, place, wish); });
}

void ReviewDeskDialog::closeDesk() {
  act(tr("Closing the review desk"),
      [place = place_](SessionContext& session) { stopReviewDesk(session, place); });
}

void ReviewDeskDialog::act(const QString& title, std::function<void(SessionContext&)> work) {
  working_ = true;
  act_->setEnabled(false);
  said_->setText(title);
  setLook(said_, "caution", false);
  const auto ended = [this] {
    working_ = false;
    said_->clear();
    read();
  };
  shell_.run(
      this, title,
      [work = std::move(work)](SessionContext& session, const ProgressCallback&) { work(session); }, ended,
      [this, ended](const Error& error) {
        ended();
        said_->setText(translatedLine(error));
        setLook(said_, "caution", true);
      });
}

void ReviewDeskDialog::copyAddress() {
  QApplication::clipboard()->setText(address_->currentText());
  copy_->setText(tr("Copied"));
}

void ReviewDeskDialog::chooseFile(QLineEdit* field, const QString& title) {
  const QString file =
      askFileToOpen(this, title, tr("Certificates and keys (*.pem *.crt *.key)"), field->text());
  if (!file.isEmpty()) {
    field->setText(file);
  }
}

}  // namespace torsio::gui
