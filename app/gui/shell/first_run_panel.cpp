// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/first_run_panel.h"

#include <QClipboard>
#include <QComboBox>
#include <QEvent>
#include <QFileDialog>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QShortcut>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "app/gui/base/background.h"
#include "app/gui/base/job_panel.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "assessment/domain/people/password_rule.h"

namespace torsio::gui {

namespace {

constexpr int kFirstRunWidth = 620;
constexpr int kCardHeight = 580;  // of the tallest step, so that the buttons stay in place
enum Step { kCentre, kAdministrator, kDatabase, kDemonstration, kAccounts };
constexpr int kNumberedSteps = 4;

QWidget* page(QVBoxLayout*& column) {
  auto* widget = new QWidget;
  column = bareLayout<QVBoxLayout>(widget, kSpace - 2);
  return widget;
}

QLabel* noteBelow(QVBoxLayout* column, QWidget* parent) {
  QLabel* note = sentence(parent);
  note->setContentsMargins(3 * kSpace + 2, 0, 0, kSpace);
  column->addWidget(note);
  return note;
}

}  // namespace

FirstRunPanel::FirstRunPanel(const QString& place, Text setBy, QWidget* parent)
    : QWidget(parent),
      setBy_(std::move(setBy)),
      background_(new Background(this)),
      steps_(new QStackedWidget(this)),
      job_(new JobPanel(this)) {
  QVBoxLayout* column = centredCard(this, kFirstRunWidth);
  column->parentWidget()->setMinimumHeight(kCardHeight);
  step_ = new QLabel(this);
  step_->setProperty("quiet", true);
  heading_ = new QLabel(this);
  heading_->setProperty("heading", true);
  why_ = sentence(this);
  answer_ = sentence(this, false);
  column->addWidget(step_);
  column->addWidget(heading_);
  column->addWidget(why_);
  column->addSpacing(kSpace);
  for (QWidget* step : {createCentreStep(), createAdministratorStep(), createDatabaseStep(),
                        createDemonstrationStep(), createAccountsStep()}) {
    steps_->addWidget(step);
  }
  column->addWidget(steps_, 1);
  answerPlace_ = new QVBoxLayout;
  answerPlace_->addWidget(answer_);
  column->addLayout(answerPlace_);
  column->addWidget(job_);
  column->addSpacing(kSpace);
  back_ = linkButton(this);
  next_ = primaryButton(this);
  auto* row = new QHBoxLayout;
  row->addWidget(back_);
  row->addStretch(1);
  row->addWidget(next_);
  column->addLayout(row);
  showPlace(place);
  connect(back_, &QPushButton::clicked, this, [this] { go(steps_->currentIndex() - 1); });
  connect(next_, &QPushButton::clicked, this, &FirstRunPanel::next);
  go(kCentre);
}

FirstRunPanel::~FirstRunPanel() = default;

QWidget* FirstRunPanel::createCentreStep() {
  QVBoxLayout* column = nullptr;
  QWidget* widget = page(column);
  language_ = new QComboBox(widget);
  for (const Language language : {Language::kEnglish, Language::kSimplifiedChinese}) {
    language_->addItem(languageName(language), static_cast<int>(language));
  }
  centre_ = new QLineEdit(widget);
  languageLabel_ = addField(column, language_);
  centreLabel_ = addField(column, centre_);
  column->addStretch(1);
  look_ = new QLabel(widget);
  look_->setProperty("subheading", true);
  column->addWidget(look_);
  auto* desks = new QHBoxLayout;
  lookTrainee_ = new QPushButton(widget);
  lookPhysician_ = new QPushButton(widget);
  lookAdministrator_ = new QPushButton(widget);
  const std::pair<QPushButton*, VisitedDesk> looks[] = {{lookTrainee_, VisitedDesk::kTrainee},
                                                        {lookPhysician_, VisitedDesk::kPhysician},
                                                        {lookAdministrator_, VisitedDesk::kAdministrator}};
  for (const auto& [button, desk] : looks) {
    desks->addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, desk = desk] { Q_EMIT lookRoundWanted(desk); });
  }
  desks->addStretch(1);
  column->addLayout(desks);
  lookNote_ = sentence(widget);
  column->addWidget(lookNote_);
  connect(language_, &QComboBox::activated, this, [this](int index) {
    Q_EMIT languageWanted(static_cast<Language>(language_->itemData(index).toInt()));
  });
  connect(centre_, &QLineEdit::returnPressed, this, &FirstRunPanel::next);
  return widget;
}

QWidget* FirstRunPanel::createAdministratorStep() {
  QVBoxLayout* column = nullptr;
  QWidget* widget = page(column);
  login_ = new QLineEdit(widget);
  password_ = secretField(widget);
  again_ = secretField(widget);
  loginLabel_ = addField(column, login_);
  passwordLabel_ = addField(column, password_);
  againLabel_ = addField(column, again_);
  column->addStretch(1);
  for (QLineEdit* field : {login_, password_, again_}) {
    connect(field, &QLineEdit::textChanged, this, [this] { say({}); });
    connect(field, &QLineEdit::returnPressed, this, &FirstRunPanel::next);
  }
  return widget;
}

void FirstRunPanel::nextOnEnter(QWidget* field) {
  for (const int key : {Qt::Key_Return, Qt::Key_Enter}) {
    auto* pressed = new QShortcut(QKeySequence(key), field, this, &FirstRunPanel::next);
    pressed->setContext(Qt::WidgetShortcut);
  }
}

QWidget* FirstRunPanel::createDatabaseStep() {
  QVBoxLayout* column = nullptr;
  QWidget* widget = page(column);
  file_ = new QRadioButton(widget);
  server_ = new QRadioButton(widget);
  file_->setChecked(true);
  path_ = new QLineEdit(widget);
  choose_ = new QPushButton(widget);
  address_ = new QLineEdit(widget);
  address_->setPlaceholderText(QStringLiteral("postgresql://torsio@server:5432/torsio"));
  test_ = new QPushButton(widget);
  column->addWidget(file_);
  fileNote_ = noteBelow(column, widget);
  auto* fileRow = new QHBoxLayout;
  fileRow->setContentsMargins(3 * kSpace + 2, 0, 0, kSpace);
  fileRow->addWidget(path_, 1);
  fileRow->addWidget(choose_);
  column->addLayout(fileRow);
  column->addWidget(server_);
  serverNote_ = noteBelow(column, widget);
  auto* serverRow = new QHBoxLayout;
  serverRow->setContentsMargins(3 * kSpace + 2, 0, 0, kSpace);
  serverRow->addWidget(address_, 1);
  column->addLayout(serverRow);
  column->addWidget(test_, 0, Qt::AlignLeft);
  column->addStretch(1);
  for (QRadioButton* choice : {file_, server_}) {
    nextOnEnter(choice);
  }
  connect(file_, &QRadioButton::toggled, this, &FirstRunPanel::showEngine);
  for (QLineEdit* field : {path_, address_}) {
    connect(field, &QLineEdit::textChanged, this, [this] { say({}); });
    connect(field, &QLineEdit::returnPressed, this, &FirstRunPanel::next);
  }
  connect(choose_, &QPushButton::clicked, this, &FirstRunPanel::chooseFile);
  connect(test_, &QPushButton::clicked, this, &FirstRunPanel::testDatabase);
  showEngine();
  return widget;
}

QWidget* FirstRunPanel::createDemonstrationStep() {
  QVBoxLayout* column = nullptr;
  QWidget* widget = page(column);
  without_ = new QRadioButton(widget);
  with_ = new QRadioButton(widget);
  without_->setChecked(true);
  column->addWidget(without_);
  withoutNote_ = noteBelow(column, widget);
  column->addWidget(with_);
  withNote_ = noteBelow(column, widget);
  column->addStretch(1);
  for (QRadioButton* choice : {without_, with_}) {
    nextOnEnter(choice);
  }
  return widget;
}

QWidget* FirstRunPanel::createAccountsStep() {
  QVBoxLayout* column = nullptr;
  QWidget* widget = page(column);
  accounts_ = new QLabel(widget);
  accounts_->setTextFormat(Qt::RichText);
  accounts_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  copy_ = linkButton(widget);
  column->addWidget(accounts_);
  column->addWidget(copy_, 0, Qt::AlignLeft);
  column->addStretch(1);
  return widget;
}

void FirstRunPanel::showPlace(const QString& place) {
  const bool server = place.contains(QLatin1String("://"));
  (server ? server_ : file_)->setChecked(true);
  (server ? address_ : path_)->setText(place);
  file_->setEnabled(setBy_.empty() || !server);
  server_->setEnabled(setBy_.empty() || server);
}

void FirstRunPanel::showEngine() {
  const bool chooses = setBy_.empty();
  path_->setEnabled(chooses && file_->isChecked());
  choose_->setEnabled(chooses && file_->isChecked());
  address_->setEnabled(chooses && !file_->isChecked());
}

QString FirstRunPanel::locator() const {
  return (file_->isChecked() ? path_ : address_)->text().trimmed();
}

void FirstRunPanel::chooseFile() {
  const QString chosenFile = QFileDialog::getSaveFileName(this, tr("Database file"), path_->text(),
                                                          tr("Torsio databases (*.sqlite)"), nullptr,
                                                          QFileDialog::DontConfirmOverwrite);
  if (!chosenFile.isEmpty()) {
    path_->setText(chosenFile);
  }
}

void FirstRunPanel::testDatabase() {
  say({});
  test_->setEnabled(false);
  background_->run(
      [where = locator().toStdString()] { return lookAtRecord(where) == RecordPlace::kCentre; },
      [this](bool inUse) {
        test_->setEnabled(true);
        next_->setFocus();  // focus had moved to the back button while the test button was disabled
        say(inUse ? tr("A centre keeps its records there already. You can sign in to it after this step")
                  : tr("The database answers and is empty: it can be used"));
        setLook(answer_, "caution", inUse);
        setLook(answer_, "good", !inUse);
      },
      [this](const std::exception_ptr& problem) {
        test_->setEnabled(true);
        test_->setFocus();
        say(problemSentence(problem));
      });
}

void FirstRunPanel::setLanguage(Language language) {
  language_->setCurrentIndex(language_->findData(static_cast<int>(language)));
}

Language FirstRunPanel::language() const {
  return static_cast<Language>(language_->currentData().toInt());
}

void FirstRunPanel::setWorking(bool working) {
  working_ = working;
  steps_->setEnabled(!working);
  back_->setEnabled(!working);
  next_->setEnabled(!working);
}

void FirstRunPanel::say(const QString& text) {
  answerPlace_->addWidget(answer_);  // it may be below a field
  answer_->show();
  setLook(answer_, "caution", !text.isEmpty());
  setLook(answer_, "good", false);
  answer_->setText(text);
}

void FirstRunPanel::sayAt(const Gap& gap) {
  say(gap.sentence);
  auto* column = qobject_cast<QVBoxLayout*>(gap.field->parentWidget()->layout());
  const int place = column != nullptr ? column->indexOf(gap.field) : -1;
  if (place >= 0) {
    column->insertWidget(place + 1, answer_);
    answer_->show();  // immediately, not in the next event loop iteration
  }
  gap.field->setFocus();
}

FirstRunPanel::Gap FirstRunPanel::missing() const {
  switch (steps_->currentIndex()) {
    case kCentre:
      return centre_->text().trimmed().isEmpty() ? Gap{tr("Enter the name of your centre"), centre_} : Gap{};
    case kAdministrator:
      if (login_->text().trimmed().isEmpty()) {
        return {tr("Enter a sign-in name"), login_};
      }
      try {
        checkPassword(password_->text().toStdString(), login_->text().trimmed().toStdString());
      } catch (...) {
        return {problemSentence(std::current_exception()), password_};
      }
      return password_->text() == again_->text() ? Gap{}
                                                 : Gap{tr("The two passwords are not the same"), again_};
    case kDatabase:
      return locator().isEmpty() ? Gap{tr("Say where the database is"), file_->isChecked() ? path_ : address_}
                                 : Gap{};
    default:
      return {};
  }
}

void FirstRunPanel::next() {
  if (working_) {
    return;
  }
  const int step = steps_->currentIndex();
  if (step == kAccounts) {
    accounts_->clear();
    Q_EMIT done();
    return;
  }
  if (const Gap gap = missing(); !gap.sentence.isEmpty()) {
    sayAt(gap);
    return;
  }
  if (step < kDemonstration) {
    go(step + 1);
    return;
  }
  FirstRunChoice choice;
  choice.first.centre = centre_->text().trimmed().toStdString();
  choice.first.login = login_->text().trimmed().toStdString();
  choice.first.password = password_->text().toStdString();
  choice.first.language = languageCode(language()).toStdString();
  choice.first.demonstration = with_->isChecked();
  choice.locator = locator();
  Q_EMIT chosen(choice);
}

void FirstRunPanel::go(int step) {
  steps_->setCurrentIndex(step);
  say({});
  retranslate();
  QWidget* const first[] = {centre_, login_, path_, without_, next_};
  first[step]->setFocus();
}

void FirstRunPanel::showAccounts(const std::vector<StartAccount>& accounts) {
  password_->clear();
  again_->clear();
  if (accounts.empty()) {
    Q_EMIT done();
    return;
  }
  QString text = QStringLiteral("<table cellspacing='8'><tr><td>%1</td><td>%2</td><td>%3</td></tr>")
                     .arg(tr("Sign-in name"), tr("Role"), tr("Start password"));
  QString plain;
  for (const StartAccount& account : accounts) {
    const QString role = account.role == "trainee" ? tr("Trainee") : tr("Rater");
    const QString login = toQString(account.login);
    const QString password = toQString(account.startPassword);
    text += QStringLiteral("<tr><td><b>%1</b></td><td>%2</td><td><code>%3</code></td></tr>")
                .arg(login, role, password);
    plain += QStringLiteral("%1\t%2\n").arg(login, password);
  }
  accounts_->setText(text + QStringLiteral("</table>"));
  accounts_->setAccessibleName(plain);
  disconnect(copy_, nullptr, nullptr, nullptr);
  connect(copy_, &QPushButton::clicked, this, [plain] { QGuiApplication::clipboard()->setText(plain); });
  go(kAccounts);
}

void FirstRunPanel::retranslate() {
  const int step = steps_->currentIndex();
  const QString headings[] = {tr("Welcome to Torsio"), tr("The first administrator"),
                              tr("Where records are kept"), tr("Sample data (optional)"),
                              tr("Accounts of the demonstration")};
  const QString reasons[] = {
      tr("Four short steps set up your centre. Nothing is written before the last one."),
      tr("This person creates all other accounts. There is no default password; choose one of at least "
         "fifteen "
         "characters, a short sentence for example."),
      tr("One computer, or a server that several stations share."),
      tr("A demonstration cohort shows every screen with content: 30 simulated trainees, ten physicians, 900 "
         "marks."),
      tr("These start passwords are shown only now. Each must be changed at the first sign-in.")};
  step_->setText(tr("Step %1 of %2").arg(step + 1).arg(kNumberedSteps));
  step_->setVisible(step < kNumberedSteps);
  heading_->setText(headings[step]);
  why_->setText(reasons[step]);
  nameField(languageLabel_, tr("Lan&guage"));
  nameField(centreLabel_, tr("&Name of the centre"));
  look_->setText(tr("Explore with sample data"));
  lookTrainee_->setText(tr("As a &trainee"));
  lookPhysician_->setText(tr("As a &physician"));
  lookAdministrator_->setText(tr("As an &administrator"));
  lookNote_->setText(tr("No password needed. Sample data are deleted at sign-out."));
  centre_->setPlaceholderText(tr("Skills laboratory, city hospital"));
  nameField(loginLabel_, tr("Sign-in &name"));
  nameField(passwordLabel_, tr("&Password"));
  nameField(againLabel_, tr("Repeat p&assword"));
  without_->setText(tr("&Start empty"));
  withoutNote_->setText(tr("People, curricula and cohorts are entered or imported."));
  with_->setText(tr("With a &demonstration cohort"));
  withNote_->setText(
      tr("Takes less than a minute. Every row is marked as a demonstration; it can be removed with one "
         "click."));
  copy_->setText(tr("Copy"));
  retranslateDatabase();
  back_->setText(tr("Back"));
  back_->setVisible(step > kCentre && step < kAccounts);
  next_->setText(step == kAccounts ? tr("I've saved these passwords")
                                   : (step == kDemonstration ? tr("Set up") : tr("Next")));
}

void FirstRunPanel::retranslateDatabase() {
  file_->setText(tr("A &file on this computer"));
  fileNote_->setText(tr("For one station. Not on a network drive: such files are damaged there."));
  path_->setAccessibleName(tr("Database file"));
  choose_->setText(tr("Choose\u2026"));
  server_->setText(tr("A Postgre&SQL server"));
  serverNote_->setText(
      tr("For several stations. Keep the password in the server account's password file (.pgpass), not "
         "in this line."));
  if (!setBy_.empty()) {
    (server_->isChecked() ? serverNote_ : fileNote_)
        ->setText(tr("Set for this computer in %1.").arg(toQString(setBy_)));
  }
  address_->setAccessibleName(tr("Address of the server"));
  test_->setText(tr("&Test the database"));
}

void FirstRunPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    say({});
    retranslate();
  }
  QWidget::changeEvent(event);
}

}  // namespace torsio::gui
