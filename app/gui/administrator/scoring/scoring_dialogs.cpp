// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/administrator/scoring/scoring_dialogs.h"

#include <algorithm>
#include <map>

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDateEdit>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/field_checks.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "app/outputs/wording/joined_sentences.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/assignment.h"

namespace torsio::gui {

namespace {

constexpr int kDefaultDays = 14;

QString translated(const char* text) {
  return QCoreApplication::translate("Scoring", text);
}

}  // namespace

std::optional<RatersInvited> chooseInvitedRaters(QWidget* parent, const std::vector<PersonRow>& raters,
                                                 const ScoringMatrix& matrix) {
  QuestionDialog dialog(
      parent, translated(QT_TRANSLATE_NOOP("Scoring", "Invite raters")),
      translated(QT_TRANSLATE_NOOP("Scoring",
                                   "Case labels reveal neither name, group nor occasion. Each rater gets "
                                   "recordings in a different order; real-arm cases follow your calls.")));
  dialog.resize(620, 560);
  auto* table = new DataTable(QString(), &dialog);
  table->setColumns({{translated(QT_TRANSLATE_NOOP("Scoring", "Rater"))},
                     {translated(QT_TRANSLATE_NOOP("Scoring", "Class"))}});
  std::vector<Row> rows;
  for (const PersonRow& rater : raters) {
    rows.push_back(
        {toQString(rater.person.id), {{toQString(rater.person.code)}, {raterClassName(rater.raterClass)}}});
  }
  table->setRows(std::move(rows));
  table->view().setSelectionMode(QAbstractItemView::ExtendedSelection);
  QStringList atWork;
  for (const ScoringMatrix::Rater& rater : matrix.raters) {
    if (rater.open > 0) {
      atWork << toQString(rater.id);
    }
  }
  table->selectAll(atWork);
  dialog.column()->addWidget(table, 1);
  auto* boxes = new QVBoxLayout;
  boxes->setSpacing(kSpace);
  dialog.column()->addLayout(boxes);
  std::vector<std::pair<std::string, QCheckBox*>> points;
  for (const Occasion& occasion : matrix.occasions) {
    auto* box = new QCheckBox(occasionName(occasion), &dialog);
    box->setChecked(true);
    boxes->addWidget(box);
    points.emplace_back(occasion.code, box);
  }
  auto* limited = new QCheckBox(translated(QT_TRANSLATE_NOOP("Scoring", "Due by the end of")), &dialog);
  limited->setObjectName(QStringLiteral("limited"));
  auto* due = new QDateEdit(QDate::currentDate().addDays(kDefaultDays), &dialog);
  due->setObjectName(QStringLiteral("due"));
  due->setCalendarPopup(true);
  showAsDate(due);
  due->setMinimumDate(QDate::currentDate());
  due->setEnabled(false);
  due->setAccessibleName(translated(QT_TRANSLATE_NOOP("Scoring", "Deadline")));
  QObject::connect(limited, &QCheckBox::toggled, due, &QWidget::setEnabled);
  auto* deadline = new QHBoxLayout;
  deadline->addWidget(limited);
  deadline->addWidget(due);
  deadline->addStretch(1);
  dialog.column()->addLayout(deadline);
  QPushButton* ask = dialog.finish(translated(QT_TRANSLATE_NOOP("Scoring", "Ask")));
  const auto showAsk = [ask, table] { ask->setEnabled(!table->selectedIds().isEmpty()); };
  QObject::connect(table, &DataTable::currentChanged, ask, showAsk);
  showAsk();
  if (dialog.exec() != QDialog::Accepted) {
    return std::nullopt;
  }
  RatersInvited asked;
  for (const QString& id : table->selectedIds()) {
    asked.raterIds.push_back(id.toStdString());
  }
  for (const auto& [code, box] : points) {
    if (box->isChecked()) {
      asked.occasionCodes.push_back(code);
    }
  }
  if (limited->isChecked()) {
    asked.dueUtc_us = due->date().endOfDay().toMSecsSinceEpoch() * 1000;
  }
  return asked;
}

std::optional<ReleaseChange> askRelease(QWidget* parent, const std::vector<ReleaseState>& states) {
  QuestionDialog dialog(parent, translated(QT_TRANSLATE_NOOP("Scoring", "Release marks")),
                        translated(QT_TRANSLATE_NOOP(
                            "Scoring", "Trainees see their marks of an occasion from the release on.")));
  auto* point = new QComboBox(&dialog);
  for (const ReleaseState& state : states) {
    point->addItem(
        translated(state.released ? QT_TRANSLATE_NOOP("Scoring", "%1: released, take back")
                                  : QT_TRANSLATE_NOOP("Scoring", "%1: release, sheets not in yet: %2 of %3"))
            .arg(occasionName(state.occasion))
            .arg(state.missing)
            .arg(state.sheets),
        toQString(state.occasion.code));
  }
  auto* reason = new QLineEdit(&dialog);
  auto* form = new QFormLayout;
  form->addRow(translated(QT_TRANSLATE_NOOP("Scoring", "Occa&sion")), point);
  form->addRow(translated(QT_TRANSLATE_NOOP("Scoring", "&Reason")), reason);
  FieldChecks checks(&dialog);
  checks.add(form, reason, [=, &states] {
    const auto at = static_cast<std::size_t>(point->currentIndex());
    const bool needed = at < states.size() && (states[at].released || states[at].missing > 0);
    return needed && reason->text().trimmed().isEmpty() ? reasonWanted() : QString();
  });
  dialog.column()->addLayout(form);
  checks.decide(dialog.finish(translated(QT_TRANSLATE_NOOP("Scoring", "Apply"))),
                [&states] { return !states.empty(); });
  QObject::connect(point, &QComboBox::currentIndexChanged, &checks, &FieldChecks::check);
  if (dialog.exec() != QDialog::Accepted) {
    return std::nullopt;
  }
  const ReleaseState& chosen = states[static_cast<std::size_t>(point->currentIndex())];
  return ReleaseChange{chosen.occasion.code, !chosen.released, reason->text().trimmed().toStdString()};
}

namespace {

Row rowOf(const AdjudicatorRequest& request) {
  QStringList by;
  QStringList reasons;
  for (const std::string& code : request.askedBy) {
    by << toQString(code);
  }
  for (const std::string& reason : request.reasons) {
    reasons << toQString(reason);
  }
  const QString point = occasionName(request.occasion);
  return {toQString(request.assignmentId),
          {{toQString(request.traineeCode)},
           {request.live ? translated(QT_TRANSLATE_NOOP("Scoring", "%1, live")).arg(point) : point,
            toQString(request.occasion.code)},
           {by.join(QStringLiteral(", "))},
           {reasons.join(QStringLiteral(" \u00B7 ")), {}, reasons.join(QLatin1Char('\n'))},
           timeCell(request.askedUtc_us)}};
}

std::vector<const AdjudicatorRequest*> chosenRequests(const std::vector<AdjudicatorRequest>& requests,
                                                      const QStringList& ids) {
  std::vector<const AdjudicatorRequest*> chosen;
  for (const AdjudicatorRequest& request : requests) {
    if (ids.contains(toQString(request.assignmentId)) && !request.free.empty()) {
      chosen.push_back(&request);
    }
  }
  return chosen;
}

/// Lists the raters who may adjudicate all these cases; for several cases, first "the freest for each".
void fillAdjudicators(QComboBox* box, const std::vector<const AdjudicatorRequest*>& chosen) {
  box->clear();
  if (chosen.empty()) {
    return;
  }
  if (chosen.size() > 1) {
    box->addItem(translated(QT_TRANSLATE_NOOP("Scoring", "for each case the least busy of the same class")),
                 QString());
  }
  for (const Adjudicator& rater : chosen.front()->free) {
    const bool forAll = std::all_of(chosen.begin(), chosen.end(), [&](const AdjudicatorRequest* one) {
      return std::any_of(one->free.begin(), one->free.end(),
                         [&](const Adjudicator& other) { return other.id == rater.id; });
    });
    if (forAll) {
      box->addItem(translated(QT_TRANSLATE_NOOP("Scoring", "%1, %2: sheets waiting: %3"))
                       .arg(toQString(rater.code), orDash(rater.classCode))
                       .arg(rater.open),
                   toQString(rater.id));
    }
  }
}

/// Returns the freest rater of the first class, including cases assigned meanwhile.
RaterId freestFor(const AdjudicatorRequest& request, const std::map<RaterId, std::size_t>& given) {
  const Adjudicator* freest = &request.free.front();
  const auto load = [&](const Adjudicator& one) {
    const auto more = given.find(one.id);
    return one.open + (more == given.end() ? 0 : more->second);
  };
  for (const Adjudicator& one : request.free) {
    if (one.classCode == request.free.front().classCode && load(one) < load(*freest)) {
      freest = &one;
    }
  }
  return freest->id;
}

}  // namespace

std::vector<AdjudicatorChosen> chooseAdjudicators(QWidget* parent,
                                                  const std::vector<AdjudicatorRequest>& requests) {
  QuestionDialog dialog(parent, translated(QT_TRANSLATE_NOOP("Scoring", "Assign an adjudicator")),
                        translated(QT_TRANSLATE_NOOP(
                            "Scoring",
                            "Physicians could not agree on these cases and ask for another opinion. The "
                            "least busy rater of the same class is suggested; nobody learns who asked.")));
  dialog.resize(860, 460);
  auto* table = new DataTable(QString(), &dialog);
  table->setColumns({{translated(QT_TRANSLATE_NOOP("Scoring", "Trainee"))},
                     {translated(QT_TRANSLATE_NOOP("Scoring", "Occasion"))},
                     {translated(QT_TRANSLATE_NOOP("Scoring", "Asked by"))},
                     {translated(QT_TRANSLATE_NOOP("Scoring", "Why"))},
                     {translated(QT_TRANSLATE_NOOP("Scoring", "Since"))}});
  table->view().setAccessibleName(translated(QT_TRANSLATE_NOOP("Scoring", "Cases that need an adjudicator")));
  std::vector<Row> rows;
  for (const AdjudicatorRequest& request : requests) {
    rows.push_back(rowOf(request));
  }
  table->setRows(std::move(rows));
  dialog.column()->addWidget(table, 1);
  auto* to = new QComboBox(&dialog);
  auto* form = new QFormLayout;
  form->addRow(translated(QT_TRANSLATE_NOOP("Scoring", "&Rater")), to);
  dialog.column()->addLayout(form);
  QPushButton* ok = dialog.finish(translated(QT_TRANSLATE_NOOP("Scoring", "Assign")));
  const auto choose = [&] {
    const std::vector<const AdjudicatorRequest*> chosen = chosenRequests(requests, table->selectedIds());
    fillAdjudicators(to, chosen);
    ok->setEnabled(to->count() > 0);
  };
  QObject::connect(table, &DataTable::currentChanged, &dialog, choose);
  table->select(toQString(requests.front().assignmentId));
  choose();
  ok->setFocus(Qt::OtherFocusReason);
  std::vector<AdjudicatorChosen> assigned;
  if (dialog.exec() != QDialog::Accepted || to->count() == 0) {
    return assigned;
  }
  std::map<RaterId, std::size_t> given;
  for (const AdjudicatorRequest* request : chosenRequests(requests, table->selectedIds())) {
    const RaterId rater = chosenId(to).empty() ? freestFor(*request, given) : RaterId(chosenId(to));
    ++given[rater];
    assigned.push_back({request->assignmentId, rater});
  }
  return assigned;
}

namespace {

struct Reassignment {
  Q_DECLARE_TR_FUNCTIONS(Reassignment)
};

/// Sheets of one rater that can be reassigned together.
struct SheetsOf {
  std::size_t rater = 0;   // column of the matrix
  bool takenBack = false;  // false: open or begun
  std::vector<std::size_t> lines{};
};

std::vector<SheetsOf> movableSheets(const ScoringMatrix& matrix, const std::vector<std::size_t>& lines) {
  std::vector<SheetsOf> all;
  for (const bool takenBack : {false, true}) {
    for (std::size_t r = 0; r < matrix.raters.size(); ++r) {
      SheetsOf sheets{r, takenBack};
      for (const std::size_t at : lines) {
        const ScoringCell& cell = matrix.lines[at].cells[r];
        const bool fits = takenBack ? cell.state == SheetState::kWithdrawn : isOutstanding(cell.state);
        if (!cell.assignmentId.empty() && fits) {
          sheets.lines.push_back(at);
        }
      }
      if (!sheets.lines.empty()) {
        all.push_back(std::move(sheets));
      }
    }
  }
  return all;
}

/// The fields of askReassignment().
class ReassignDialog {
 public:
  ReassignDialog(QWidget* parent, const ScoringMatrix& matrix, const std::vector<std::size_t>& lines,
                 const std::vector<PersonRow>& raters)
      : matrix_(matrix),
        raters_(raters),
        movable_(movableSheets(matrix, lines)),
        dialog_(parent, Reassignment::tr("Reassign sheets"),
                lines.size() == 1
                    ? Reassignment::tr("%1, %2").arg(toQString(matrix.lines[lines.front()].traineeCode),
                                                     occasionName(matrix.lines[lines.front()].occasion))
                    : Reassignment::tr("The sheets of %n row(s) of the matrix.", nullptr,
                                       static_cast<int>(lines.size()))),
        from_(named(new QComboBox(&dialog_), "from")),
        to_(named(new QComboBox(&dialog_), "to")),
        what_(named(sentence(&dialog_), "what")),
        reason_(named(new QLineEdit(&dialog_), "reason")),
        checks_(&dialog_) {
    for (const SheetsOf& sheets : movable_) {
      const QString text =
          sheets.takenBack ? Reassignment::tr("%1: taken back %2") : Reassignment::tr("%1: open or begun %2");
      from_->addItem(text.arg(toQString(matrix_.raters[sheets.rater].code)).arg(sheets.lines.size()));
    }
    auto* form = new QFormLayout;
    form->addRow(Reassignment::tr("&From"), from_);
    checks_.add(form, from_, [this] {
      return sheets() == nullptr ? Reassignment::tr("None of these sheets is open or was taken back.")
                                 : QString();
    });
    form->addRow(Reassignment::tr("&To"), to_);
    checks_.add(form, to_, [this] {
      return sheets() != nullptr && changingHands() == 0
                 ? Reassignment::tr("Has been asked about all these cases already. Choose another rater.")
                 : QString();
    });
    form->addRow(Reassignment::tr("&Reason"), reason_);
    checks_.addNeeded(form, reason_, reasonWanted());
    dialog_.column()->addLayout(form);
    dialog_.column()->addWidget(what_);
    checks_.decide(dialog_.finish(Reassignment::tr("Reassign")));
    QObject::connect(from_, &QComboBox::currentIndexChanged, &dialog_, [this] { fillTo(); });
    QObject::connect(to_, &QComboBox::currentIndexChanged, &dialog_, [this] { tell(); });
    fillTo();
    checks_.touch(from_);  // nothing to choose
  }

  std::optional<SheetsChosen> ask() {
    if (dialog_.exec() != QDialog::Accepted) {
      return std::nullopt;
    }
    SheetsChosen chosen{{}, chosenId(to_), reason_->text().trimmed().toStdString()};
    for (const std::size_t at : sheets()->lines) {
      chosen.sheets.push_back(matrix_.lines[at].cells[sheets()->rater].assignmentId);
    }
    return chosen;
  }

 private:
  [[nodiscard]] const SheetsOf* sheets() const {
    const auto at = static_cast<std::size_t>(from_->currentIndex());
    return at < movable_.size() ? &movable_[at] : nullptr;
  }

  void fillTo() {
    to_->clear();
    if (sheets() != nullptr && sheets()->takenBack) {
      const ScoringMatrix::Rater& rater = matrix_.raters[sheets()->rater];
      to_->addItem(Reassignment::tr("%1 again").arg(toQString(rater.code)), toQString(rater.id));
    } else if (sheets() != nullptr) {
      to_->addItem(Reassignment::tr("nobody: take them back only"), QString());
      for (const PersonRow& rater : raters_) {
        if (rater.person.id != matrix_.raters[sheets()->rater].id) {
          to_->addItem(
              Reassignment::tr("%1, %2").arg(toQString(rater.person.code), raterClassName(rater.raterClass)),
              toQString(rater.person.id));
        }
      }
    }
    tell();
    checks_.check();
  }

  /// Counts the selected sheets whose case the other rater already scores.
  [[nodiscard]] std::size_t askedAlready() const {
    const auto rater = std::find_if(matrix_.raters.begin(), matrix_.raters.end(),
                                    [&](const ScoringMatrix::Rater& one) { return one.id == chosenId(to_); });
    if (rater == matrix_.raters.end() || sheets()->takenBack) {
      return 0;
    }
    const auto column = static_cast<std::size_t>(rater - matrix_.raters.begin());
    return static_cast<std::size_t>(
        std::count_if(sheets()->lines.begin(), sheets()->lines.end(), [&](std::size_t at) {
          const ScoringCell& cell = matrix_.lines[at].cells[column];
          return !cell.assignmentId.empty() && cell.state != SheetState::kWithdrawn;
        }));
  }

  [[nodiscard]] std::size_t changingHands() const { return sheets()->lines.size() - askedAlready(); }

  void tell() {
    if (sheets() == nullptr) {
      what_->clear();
      return;
    }
    const std::size_t stay = askedAlready();
    QStringList said{
        Reassignment::tr("%n sheet(s) change hands.", nullptr, static_cast<int>(changingHands()))};
    if (stay > 0) {
      said << Reassignment::tr("%n stay(s): the other rater is asked about these cases already.", nullptr,
                               static_cast<int>(stay));
    }
    what_->setText(joinedSentences(said));
  }

  const ScoringMatrix& matrix_;
  const std::vector<PersonRow>& raters_;
  std::vector<SheetsOf> movable_;
  QuestionDialog dialog_;
  QComboBox* from_;
  QComboBox* to_;
  QLabel* what_;
  QLineEdit* reason_;
  FieldChecks checks_;
};

}  // namespace

std::optional<SheetsChosen> askReassignment(QWidget* parent, const ScoringMatrix& matrix,
                                            const std::vector<std::size_t>& lines,
                                            const std::vector<PersonRow>& raters) {
  return ReassignDialog(parent, matrix, lines, raters).ask();
}

}  // namespace torsio::gui
