// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/people/roster_page.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <QCheckBox>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/copies_text.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/administrator/people/consent_dialog.h"
#include "app/gui/administrator/people/consent_texts_dialog.h"
#include "app/gui/administrator/people/requests_dialog.h"
#include "app/gui/administrator/people/roster_imports_dialog.h"
#include "app/gui/administrator/people/roster_wizard.h"
#include "app/gui/administrator/people/user_dialogs.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/table_choice.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/services/access/all_or_none.h"
#include "app/services/maintenance/person_package.h"
#include "app/services/people/consent_service.h"
#include "assessment/domain/people/consent.h"

namespace torsio::gui {

RosterPage::RosterPage(ShellContext& shell)
    : Page(shell),
      heading_(new PageHeading(this)),
      import_(primaryButton(this)),
      undo_(named(new QPushButton(this), "undoImport")),
      add_(new QPushButton(this)),
      texts_(named(new QPushButton(this), "consentTexts")),
      requests_(named(new QPushButton(this), "personRequests")),
      table_(named(new DataTable(QStringLiteral("roster"), this), "table")),
      names_(new QCheckBox(this)),
      erase_(nullptr) {
  table_->addTool(names_);
  edit_ = listButton(table_);
  state_ = listButton(table_);
  export_ = listButton(table_);
  consents_ = named(listButton(table_), "consents");
  package_ = named(listButton(table_), "exportPerson");
  erase_ = named(listButton(table_), "erasePerson");
  heading_->addAction(requests_);
  heading_->addAction(texts_);
  heading_->addAction(undo_);
  heading_->addAction(add_);
  heading_->addAction(import_);
  QVBoxLayout* column = pageColumn(this);
  column->addWidget(heading_);
  column->addWidget(table_, 1);

  connect(import_, &QPushButton::clicked, this, &RosterPage::import);
  connect(texts_, &QPushButton::clicked, this, [this] { ConsentTextsDialog(this->shell(), this).exec(); });
  connect(requests_, &QPushButton::clicked, this, &RosterPage::showRequests);
  connect(add_, &QPushButton::clicked, this, &RosterPage::add);
  connect(undo_, &QPushButton::clicked, this, [this] {
    RosterImportsDialog(this->shell(), this).exec();
    read();
  });
  connect(edit_, &QPushButton::clicked, this, &RosterPage::edit);
  connect(state_, &QPushButton::clicked, this, &RosterPage::switchState);
  connect(export_, &QPushButton::clicked, this, &RosterPage::exportList);
  connect(consents_, &QPushButton::clicked, this, [this] {
    ConsentDialog::People people;
    for (const NamedPersonRow* one : chosen()) {
      people.emplace_back(one->row.person.id, toQString(one->row.person.code));
    }
    if (!people.empty()) {
      ConsentDialog(this->shell(), people, this).exec();
      read();
    }
  });
  connect(package_, &QPushButton::clicked, this, &RosterPage::askExportRecords);
  connect(erase_, &QPushButton::clicked, this, &RosterPage::askEraseRecords);
  connect(names_, &QCheckBox::toggled, this, &RosterPage::read);
  connect(table_, &DataTable::currentChanged, this, &RosterPage::showButtons);
  connect(table_, &DataTable::activated, this, &RosterPage::edit);
  retranslate();
}

void RosterPage::enter(const QVariant&) {
  names_->setVisible(shell().may(Operation::kPersonViewIdentity));
  package_->setVisible(shell().may(Operation::kPersonExport));
  erase_->setVisible(shell().may(Operation::kPersonErase));
  requests_->setVisible(shell().may(Operation::kPersonExport));
  undo_->setVisible(shell().may(Operation::kPersonEdit) && shell().may(Operation::kPersonErase));
  for (QPushButton* button : {import_, add_, edit_, state_}) {
    button->setVisible(shell().may(Operation::kPersonEdit));
  }
  read();
}

void RosterPage::retranslate() {
  heading_->setTexts(tr("Roster"),
                     tr("Who trains and who scores. Everything else in the record knows them by their "
                        "code only."));
  import_->setText(tr("&Import a roster\u2026"));
  add_->setText(tr("&New person\u2026"));
  undo_->setText(tr("&Undo an import\u2026"));
  texts_->setText(tr("Consent &texts\u2026"));
  names_->setText(tr("Show na&mes"));
  edit_->setText(tr("&Change\u2026"));
  export_->setText(tr("&Export\u2026"));
  consents_->setText(tr("C&onsents\u2026"));
  package_->setText(tr("Export recor&ds of people\u2026"));
  package_->setToolTip(tr("Everything the record holds about each selected person, for that person"));
  erase_->setText(tr("Erase on re&quest\u2026"));
  table_->setColumns({{tr("Code")},
                      {tr("Name")},
                      {tr("Number")},
                      {tr("Trains")},
                      {tr("Scores as")},
                      {tr("Sex")},
                      {tr("Level")},
                      {tr("Experience")},
                      {tr("Consent to the record")},
                      {tr("State")}});
  table_->setEmptyText(tr("Nobody yet. Import the roster of your centre, or add people by hand."));
  showContent();
}

void RosterPage::read() {
  attempt(shell(), [&] {
    people_.clear();
    if (names_->isChecked()) {
      people_ = namedPeople(shell().session());
    } else {
      for (PersonRow& row : people(shell().session())) {
        people_.push_back({std::move(row), {}});
      }
    }
    waiting_ = 0;
    if (shell().may(Operation::kPersonExport)) {
      const std::vector<PersonRequest> requests = personRequests(shell().session());
      waiting_ = static_cast<std::size_t>(std::count_if(
          requests.begin(), requests.end(), [](const PersonRequest& one) { return !one.answer; }));
    }
    showContent();
  });
}

void RosterPage::showRequests() {
  PersonRequestsDialog dialog(shell(), this);
  dialog.exec();
  read();
  if (!dialog.person().empty()) {
    table_->filter().clear();
    table_->select(toQString(dialog.person()));
  }
}

void RosterPage::showContent() {
  requests_->setText(waiting_ == 0 ? tr("A&sked for\u2026") : tr("A&sked for (%1)\u2026").arg(waiting_));
  requests_->setProperty("caution", waiting_ > 0);
  requests_->setToolTip(tr("What trainees asked for about their own record"));
  std::vector<Row> rows;
  rows.reserve(people_.size());
  for (const NamedPersonRow& named : people_) {
    const PersonRow& row = named.row;
    const bool consents =
        std::find(row.consents.begin(), row.consents.end(), kTrainingRecord) != row.consents.end();
    rows.push_back({toQString(row.person.id),
                    {{toQString(row.person.code)},
                     {orDash(named.identity.fullName)},
                     {orDash(named.identity.externalId)},
                     {row.trainee ? tr("yes") : QStringLiteral("\u2013")},
                     {raterClassName(row.raterClass)},
                     {row.person.sex.empty() ? orDash({}) : levelName(row.person.sex)},
                     {orDash(row.person.level)},
                     {orDash(row.person.experience)},
                     {consents ? tr("given") : tr("not given")},
                     {row.person.state == PersonState::kActive ? tr("active") : tr("left")}}});
  }
  table_->setRows(std::move(rows));
  for (const int column : {1, 2}) {
    table_->setColumnHidden(column, !names_->isChecked());
  }
  showButtons();
}

std::vector<const NamedPersonRow*> RosterPage::chosen() const {
  return chosenRows(*table_, people_, [](const NamedPersonRow& one) { return one.row.person.id; });
}

QString RosterPage::codesOf(const std::vector<const NamedPersonRow*>& people) {
  return firstFew(namesOf(people, [](const NamedPersonRow& one) { return one.row.person.code; }));
}

void RosterPage::showButtons() {
  const PersonId id = table_->currentId().toStdString();
  const auto person = std::find_if(people_.begin(), people_.end(),
                                   [&id](const NamedPersonRow& named) { return named.row.person.id == id; });
  const bool any = person != people_.end();
  edit_->setEnabled(any && table_->selectedIds().size() == 1);
  for (QPushButton* button : {state_, consents_, package_, erase_}) {
    button->setEnabled(any);
  }
  const bool left = any && person->row.person.state != PersonState::kActive;
  state_->setText(left ? tr("Came &back\u2026") : tr("Has &left\u2026"));
}

void RosterPage::import() {
  RosterWizard wizard(shell(), this);
  if (wizard.exec() != QDialog::Accepted || !wizard.outcome()) {
    return;
  }
  shell().notify(
      tr("People added: %1, changed: %2").arg(wizard.outcome()->added).arg(wizard.outcome()->changed));
  read();
}

void RosterPage::add() {
  attempt(shell(), [&] {
    const std::optional<PersonEdit> edit =
        askPerson(this, std::nullopt, ensureRaterClasses(shell().session()));
    if (!edit) {
      return;
    }
    const PersonId id = addPerson(shell().session(), edit->entry);
    read();
    table_->select(toQString(id));
  });
}

void RosterPage::edit() {
  const PersonId id = table_->currentId().toStdString();
  if (id.empty() || !edit_->isVisible()) {
    return;
  }
  attempt(shell(), [&] {
    const std::optional<PersonEdit> edit =
        askPerson(this, personEntry(shell().session(), id), ensureRaterClasses(shell().session()));
    if (!edit) {
      return;
    }
    changePerson(shell().session(), id, edit->entry, edit->reason);
    read();
  });
}

void RosterPage::switchState() {
  const PersonId id = table_->currentId().toStdString();
  const auto person = std::find_if(people_.begin(), people_.end(),
                                   [&id](const NamedPersonRow& named) { return named.row.person.id == id; });
  if (person == people_.end()) {
    return;
  }
  // All selected people with the same state as the current one.
  const PersonState state = person->row.person.state;
  std::vector<const NamedPersonRow*> alike = chosen();
  std::erase_if(alike, [state](const NamedPersonRow* one) { return one->row.person.state != state; });
  attempt(shell(), [&] {
    const bool active = state == PersonState::kActive;
    const QString code = codesOf(alike);
    const std::optional<std::string> reason =
        active ? askReason(this, tr("Has left"),
                           tr("The record of %1 is kept, but %1 no longer appears in lists.").arg(code))
               : askReason(this, tr("Came back"), tr("%1 appears in lists again.").arg(code));
    if (!reason) {
      return;
    }
    allOrNone(shell().session(), alike, [&](const NamedPersonRow* one) {
      setPersonState(shell().session(), one->row.person.id,
                     active ? PersonState::kLeft : PersonState::kActive, *reason);
    });
    read();
  });
}

void RosterPage::askExportRecords() {
  const std::vector<const NamedPersonRow*> people = chosen();
  if (people.empty()) {
    return;
  }
  const bool one = people.size() == 1;
  const QString codes = codesOf(people);
  const std::optional<std::string> reason =
      askReason(this, tr("Export records of people"),
                one ? tr("A new folder will hold everything about %1: tables, recordings and a list of all "
                         "files. It contains the name; give it to nobody else.")
                          .arg(codes)
                    : tr("A new folder will hold a folder for each of %1, with everything about them: "
                         "tables, recordings and a list of all files. Each contains a name; give each to its "
                         "own person and to nobody else.")
                          .arg(codes));
  if (!reason) {
    return;
  }
  const QString folder = askFileToSave(
      this,
      one ? tr("New folder for the record of %1").arg(codes)
          : tr("New folder for the records of %1").arg(codes),
      one ? QStringLiteral("record-%1").arg(codes) : QStringLiteral("records"), tr("Folder (*)"));
  if (!folder.isEmpty()) {
    exportRecords(toPath(folder), *reason);
  }
}

void RosterPage::exportRecords(const std::filesystem::path& folder, const std::string& reason) {
  std::vector<PersonId> ids;
  for (const NamedPersonRow* one : chosen()) {
    ids.push_back(one->row.person.id);
  }
  if (ids.empty()) {
    return;
  }
  shell().run(
      this, tr("Exporting records"),
      [ids, folder, reason](SessionContext& session, const ProgressCallback& progress) {
        if (ids.size() == 1) {
          return exportPersonPackage(session, ids.front(), folder, reason);
        }
        PersonPackage written{.folder = folder};
        for (const PersonPackage& one : exportPersonPackages(session, ids, folder, reason, progress)) {
          written.tables += one.tables;
          written.recordings += one.recordings;
        }
        return written;
      },
      [this](const PersonPackage& written) {
        shell().notify(tr("Tables (%1) and recordings (%2) written to %3")
                           .arg(written.tables)
                           .arg(written.recordings)
                           .arg(toQString(written.folder.string())));
      });
}

void RosterPage::askEraseRecords() {
  const std::vector<const NamedPersonRow*> people = chosen();
  std::vector<PersonId> ids;
  for (const NamedPersonRow* one : people) {
    ids.push_back(one->row.person.id);
  }
  if (ids.empty()) {
    return;
  }
  QString copies;
  attempt(shell(), [&] { copies = copiesText(shell().session(), ids, locale()); });
  const std::optional<std::string> reason =
      askReason(this, tr("Erase on request"),
                tr("Name, number and recordings of %1 are erased for good. Marks stay without a person, so "
                   "that statistics remain right. This cannot be taken back.")
                        .arg(codesOf(people)) +
                    copies);
  if (!reason) {
    return;
  }
  std::vector<DutyWish> wishes;
  for (const PersonId& id : ids) {
    wishes.push_back({.act = DutyAct::kErase, .subject = id, .reason = *reason});
  }
  attempt(shell(), [&] {
    const std::size_t erased = actOrAskForAll(this, shell(), wishes, [&](const DutyWish& wish) {
      erasePersonRecord(shell().session(), wish.subject, *reason);
    });
    if (erased > 0) {
      shell().notify(tr("%n record(s) erased", nullptr, static_cast<int>(erased)));
    }
  });
  read();
}

void RosterPage::exportList() {
  const bool withNames = names_->isChecked();
  const TableChoice choice =
      askTableToSave(this, withNames ? tr("Export with names") : tr("Export under codes"),
                     withNames ? QStringLiteral("people-named") : QStringLiteral("people"));
  if (choice.file.isEmpty()) {
    return;
  }
  shell().run(
      this, tr("Exporting people"),
      [choice, withNames](SessionContext& session, const ProgressCallback&) {
        return exportPeople(session, toPath(choice.file), withNames, choice.look);
      },
      [this, choice](std::size_t count) {
        shell().notify(tr("People written to %2: %1").arg(count).arg(choice.file));
      });
}

}  // namespace torsio::gui
