// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of the case page.
#include <cmath>

#include <QFrame>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>

#include "app/gui/base/translated_text.h"
#include "app/gui/physician/case_page.h"
#include "app/gui/physician/replay_panel.h"
#include "app/gui/physician/review_labels.h"
#include "app/gui/physician/sheet_editor_panel.h"
#include "app/gui/physician/sheet_panel.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/icons.h"
#include "app/gui/widgets/value_text.h"
#include "app/outputs/wording/joined_sentences.h"
#include "assessment/domain/rating/rubric.h"

namespace torsio::gui {

namespace {

constexpr std::size_t kListedRemarks = 6;
constexpr double kRounding = 0.1;  // percent: the last sample of a recording has no duration

}  // namespace

void CasePage::retranslate() {
  replay_->retranslate();
  sheet_->retranslate();
  undo_->setText(tr("Undo"));
  redo_->setText(tr("Redo"));
  clear_->setText(tr("Clear"));
  clear_->setToolTip(tr("Removes every mark, reason and comment; Undo brings them back"));
  advance_->setText(tr("Au&to-advance"));
  advance_->setToolTip(tr("After each mark the next row is selected automatically"));
  submit_->setText(tr("Submit"));
  submit_->setToolTip(tr("Checks the sheet and asks once more (Ctrl+Enter)"));
  bookmark_->setText(tr("Bookmark"));
  bookmark_->setToolTip(tr("Bookmarks this moment for yourself (B)"));
  remark_->setText(tr("Remark"));
  remark_->setToolTip(tr("Writes to the trainee at this moment (R)"));
  remarkField_->setPlaceholderText(
      tr("Remark at this moment, for the trainee. Enter saves it, Esc discards it"));
  remarkField_->setAccessibleName(tr("Remark at this moment"));
  stripReason_->setPlaceholderText(tr("Why are you changing the mark?"));
  stripReason_->setAccessibleName(tr("Why are you changing the mark?"));
  stripBack_->setText(tr("Back to the sheet"));
  saved_.again();
  showAll();
}

std::vector<std::pair<QString, QString>> CasePage::keys() const {
  std::vector<std::pair<QString, QString>> all = replayKeys();
  all.emplace_back(tr("Bookmark this moment, for yourself"), QStringLiteral("B"));
  all.emplace_back(tr("Remark at this moment, for the trainee"), QStringLiteral("R"));
  all.emplace_back(tr("Edit your nearest remark"), QStringLiteral("Shift+R"));
  for (auto& one : sheetKeys()) {
    all.push_back(std::move(one));
  }
  all.emplace_back(tr("Not assessable: type why, Enter"), QStringLiteral("N"));
  return all;
}

void CasePage::applyTheme(const Theme& theme) {
  replay_->setTheme(theme);
  sheet_->setTheme(theme);
  remarks_->clear();  // otherwise the links of a label keep their old colour
  showRemarks();
}

QString CasePage::rowName(const std::string& row) const {
  for (const RubricLine& line : opened_.rubric.rows) {
    if (line.code == row) {
      return toQString(Text(line.label));
    }
  }
  return tr("Overall");
}

QString CasePage::stepName(const SheetChange& change) const {
  switch (change.kind) {
    case SheetChange::Kind::kScore:
      return tr("mark of %1").arg(rowName(change.row));
    case SheetChange::Kind::kCleared:
      return tr("clearing of %1").arg(rowName(change.row));
    case SheetChange::Kind::kNotAssessable:
      return tr("reason for %1").arg(rowName(change.row));
    case SheetChange::Kind::kComment:
      return tr("comment");
    case SheetChange::Kind::kAllCleared:
      return tr("clearing of the sheet");
  }
  return {};
}

QString CasePage::checkText(const SheetCheck& check) const {
  QStringList parts;
  if (!check.unanswered.empty()) {
    QStringList rows;
    for (const std::string& row : check.unanswered) {
      rows << rowName(row);
    }
    parts << tr("Still open: %1.").arg(rows.join(tr(", ")));
  }
  if (!opened_.shown.live) {
    const QString share = tr("%1 %").arg(std::floor(check.watchedShare * 100.0 + kRounding));
    const QString least = tr("%1 %").arg(std::round(rules_.minimumWatched * 100.0));
    parts << (check.watchedTooLittle ? tr("Watched %1 so far; at least %2 is asked.").arg(share, least)
                                     : tr("Watched %1.").arg(share));
  }
  if (check.speedNotAllowed) {
    parts << tr("It was played at a speed that is not allowed.");
  }
  if (check.allTheSame) {
    parts << tr("All rows have the same mark. Is that intended?");
  }
  if (check.farApart) {
    parts << tr("The rows lie far apart. Is that intended?");
  }
  if (check.overallOutside) {
    parts << tr("The overall mark is outside the rows' range. Is that intended?");
  }
  if (check.mayBeSubmitted()) {
    parts << tr("Submitting seals the sheet.");
  }
  return joinedSentences(parts);
}

QString CasePage::versionsText() const {
  QStringList lines;
  for (const SheetVersion& one : versions_) {
    const QString day = dayText(one.submittedUtc_us);
    lines << (one.amendReason.empty() ? tr("Version %1, %2").arg(one.version).arg(day)
              : one.afterPanel
                  ? tr("Version %1, %2, moved after the panel's marks were open: %3")
                        .arg(one.version)
                        .arg(day, toQString(one.amendReason))
                  : tr("Version %1, %2: %3").arg(one.version).arg(day, toQString(one.amendReason)));
  }
  return lines.join(QLatin1Char('\n'));
}

void CasePage::showAll() {
  if (sheet_->editor() == nullptr) {
    return;
  }
  const bool sealed = opened_.state == SheetState::kSubmitted;
  title_->setText(tr("Case %1").arg(toQString(opened_.shown.label)));
  QStringList facts;
  if (opened_.shown.length_us) {
    facts << tr("%1 long").arg(clockTenthsOf(*opened_.shown.length_us));
  }
  if (sealed) {
    facts << (amending_ ? tr("submitted, being amended") : tr("submitted and sealed"));
    if (versions_.size() > 1) {
      facts << tr("version %1").arg(versions_.back().version);
    }
  }
  if (!sealed && opened_.shown.dueUtc_us) {
    facts << tr("due %1").arg(dayText(*opened_.shown.dueUtc_us));
  }
  facts_->setText(facts.join(QStringLiteral("  \u00b7  ")));
  facts_->setToolTip(sealed ? versionsText() : QString());
  sheet_->setReadOnly(sealed && !amending_);
  amend_->setText(opened_.panelOpen ? tr("&Move with a reason\u2026") : tr("&Amend\u2026"));
  amend_->setToolTip(
      opened_.panelOpen
          ? tr("The panel's marks are open: a new version is flagged; the submitted one is kept")
          : tr("Makes a new version with a reason; the submitted one is kept"));
  amend_->setVisible(sealed && !amending_);
  submit_->setVisible(!sealed);
  strip_->setVisible(sheet_->asking() || amending_);
  stripReason_->setVisible(amending_);
  if (amending_) {
    stripText_->setText(
        opened_.panelOpen
            ? tr("The panel's marks are open: you move your mark with a reason, and it is flagged as moved "
                 "after them. Both versions are kept.")
            : tr("Change what must be changed, give the reason, seal the new version. Both versions are "
                 "kept."));
    stripGo_->setText(tr("Seal the new version"));
    stripGo_->setEnabled(true);
  } else if (sheet_->asking()) {
    showCheck();
  }
  showHistory();
  showRemarks();
}

void CasePage::showCheck() {
  const SheetCheck check =
      checkSheet(opened_, sheet_->editor()->sheet(), watched_, rules_, shell().session().now_us());
  stripText_->setText(checkText(check));
  setLook(stripText_, "caution", !check.mayBeSubmitted());
  stripGo_->setText(tr("Submit and seal (Ctrl+Enter)"));
  stripGo_->setEnabled(check.mayBeSubmitted());
}

void CasePage::showHistory() {
  const bool open = opened_.state != SheetState::kSubmitted || amending_;
  undo_->setEnabled(open && sheet_->editor()->canUndo());
  redo_->setEnabled(open && sheet_->editor()->canRedo());
  clear_->setEnabled(open);
  const auto undoable = sheet_->editor()->undoable();
  const auto redoable = sheet_->editor()->redoable();
  undo_->setToolTip(undoable ? tr("Undo %1 (Ctrl+Z)").arg(stepName(*undoable)) : tr("Nothing to undo"));
  redo_->setToolTip(redoable ? tr("Redo %1 (Ctrl+Y)").arg(stepName(*redoable)) : tr("Nothing to redo"));
}

void CasePage::showRemarks() {
  bookmark_->setEnabled(replay_->ready());
  remark_->setEnabled(replay_->ready());
  std::vector<std::int64_t> times_us;
  QStringList lines;
  QStringList before;
  for (const CaseRemark& one : caseRemarks_) {
    times_us.push_back(one.time_us);
    if (one.text.empty() || static_cast<std::size_t>(lines.size()) >= kListedRemarks) {
      continue;
    }
    const QString words = toQString(one.text).toHtmlEscaped();
    lines << QStringLiteral("<a href=\"%1\">%2</a> ").arg(toQString(one.id), clockTenthsOf(one.time_us)) +
                 (one.editedUtc_us != 0 ? tr("%1 (edited)").arg(words) : words);
    for (const RemarkWording& old : one.earlier) {
      before << tr("%1, before it was edited: %2").arg(clockTenthsOf(one.time_us), toQString(old.text));
    }
  }
  replay_->setBookmarks(std::move(times_us));
  remarks_->setText(lines.isEmpty()
                        ? tr("Only you see bookmarks; remarks reach the trainee when the marks are released.")
                        : lines.join(QStringLiteral(" &nbsp; \u00b7 &nbsp; ")));
  remarks_->setToolTip(
      lines.isEmpty()
          ? QString()
          : (QStringList{tr(
                 "Click a time to edit its remark (Shift+R: the nearest one); earlier wordings are kept.")} +
             before)
                .join(QLatin1Char('\n'))
                .toHtmlEscaped()
                .replace(QLatin1Char('\n'), QStringLiteral("<br>")));
}

void CasePage::editRemark(const RemarkId& id) {
  const CaseRemark* chosen = nullptr;
  const auto distance = [this](const CaseRemark& one) {
    return std::abs(one.time_us - replay_->position_us());
  };
  for (const CaseRemark& one : caseRemarks_) {
    const bool nearer = chosen == nullptr || distance(one) < distance(*chosen);
    if (!one.text.empty() && (id.empty() ? nearer : one.id == id)) {
      chosen = &one;
    }
  }
  if (chosen == nullptr) {
    return;
  }
  askRemark();
  edited_ = chosen->id;
  remarkField_->setText(toQString(chosen->text));
  remarkField_->selectAll();
}

}  // namespace torsio::gui
