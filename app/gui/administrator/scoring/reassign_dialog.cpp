// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/scoring/reassign_dialog.h"

#include <algorithm>

#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/administrator/base/study_labels.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/field_checks.h"
#include "app/gui/widgets/form.h"
#include "app/outputs/wording/joined_sentences.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/assignment.h"

namespace torsio::gui {

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
        from_(new QComboBox(&dialog_)),
        to_(new QComboBox(&dialog_)),
        what_(sentence(&dialog_)),
        reason_(new QLineEdit(&dialog_)),
        checks_(&dialog_) {
    from_->setObjectName(QStringLiteral("from"));
    to_->setObjectName(QStringLiteral("to"));
    what_->setObjectName(QStringLiteral("what"));
    reason_->setObjectName(QStringLiteral("reason"));
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
                 ? Reassignment::tr("Asked about all these cases already: choose somebody else.")
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
