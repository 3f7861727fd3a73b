// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/review/sheet_editor.h"

#include <algorithm>
#include <utility>

#include "sim/core/contracts.h"

namespace torsio {

namespace {

Sheet inRubricOrder(const RubricRevision& rubric, Sheet sheet) {
  std::vector<SheetRow> rows;
  for (const RubricLine& line : rubric.rows) {
    const auto found = std::find_if(sheet.rows.begin(), sheet.rows.end(),
                                    [&](const SheetRow& row) { return row.code == line.code; });
    rows.push_back(found == sheet.rows.end() ? SheetRow{line.code, {}, {}} : *found);
  }
  sheet.rows = std::move(rows);
  return sheet;
}

void put(Sheet& sheet, SheetRow* row, SheetAnswer answer) {
  (row != nullptr ? row->score_steps : sheet.overall_steps) = answer.score_steps;
  (row != nullptr ? row->notAssessableReason : sheet.notAssessableReason) =
      std::move(answer.notAssessableReason);
}

}  // namespace

SheetEditor::SheetEditor(RubricRevision rubric, Sheet start, bool withOverall)
    : rubric_(std::move(rubric)), withOverall_(withOverall) {
  states_.push_back({inRubricOrder(rubric_, std::move(start)), {}, false});
}

std::vector<std::string> SheetEditor::order() const {
  std::vector<std::string> codes;
  for (const RubricLine& row : rubric_.rows) {
    codes.push_back(row.code);
  }
  if (withOverall_) {
    codes.push_back(kOverallRow);
  }
  return codes;
}

SheetRow* SheetEditor::rowIn(Sheet& sheet, const std::string& code) {
  if (code == kOverallRow) {
    return nullptr;
  }
  const auto found = std::find_if(sheet.rows.begin(), sheet.rows.end(),
                                  [&](const SheetRow& row) { return row.code == code; });
  TORSIO_EXPECTS(found != sheet.rows.end());
  return &*found;
}

SheetAnswer SheetEditor::answer(const std::string& row) const {
  if (row == kOverallRow) {
    return {sheet().overall_steps, sheet().notAssessableReason};
  }
  const auto found = std::find_if(sheet().rows.begin(), sheet().rows.end(),
                                  [&](const SheetRow& line) { return line.code == row; });
  TORSIO_EXPECTS(found != sheet().rows.end());
  return {found->score_steps, found->notAssessableReason};
}

const ScoreScale& SheetEditor::scale(const std::string& row) const {
  if (row == kOverallRow) {
    return rubric_.overall;
  }
  const auto found = std::find_if(rubric_.rows.begin(), rubric_.rows.end(),
                                  [&](const RubricLine& line) { return line.code == row; });
  TORSIO_EXPECTS(found != rubric_.rows.end());
  return found->scale;
}

bool SheetEditor::apply(Sheet next, SheetChange change, bool joins) {
  states_.resize(at_ + 1);
  State& present = states_[at_];
  if (joins && at_ > 0 && present.open && present.change.kind == change.kind &&
      present.change.row == change.row) {
    present.sheet = std::move(next);
    return true;
  }
  const bool open =
      change.kind != SheetChange::Kind::kCleared && change.kind != SheetChange::Kind::kAllCleared;
  states_.push_back({std::move(next), std::move(change), open});
  ++at_;
  return true;
}

bool SheetEditor::setScore(const std::string& row, std::int64_t score_steps, bool merge) {
  const ScoreScale& limits = scale(row);
  const SheetAnswer wanted{score_steps, {}};
  if (!isOnScale(score_steps, limits) || answer(row) == wanted) {
    return false;
  }
  Sheet next = sheet();
  put(next, rowIn(next, row), wanted);
  return apply(std::move(next), {SheetChange::Kind::kScore, row}, merge);
}

bool SheetEditor::setNotAssessable(const std::string& row, const std::string& reason) {
  if (reason.empty()) {
    return clear(row);
  }
  const SheetAnswer wanted{std::nullopt, reason};
  if (answer(row) == wanted) {
    return false;
  }
  Sheet next = sheet();
  put(next, rowIn(next, row), wanted);
  return apply(std::move(next), {SheetChange::Kind::kNotAssessable, row}, true);
}

bool SheetEditor::clear(const std::string& row) {
  if (!answer(row).given()) {
    return false;
  }
  Sheet next = sheet();
  put(next, rowIn(next, row), {});
  return apply(std::move(next), {SheetChange::Kind::kCleared, row}, false);
}

bool SheetEditor::clearAll() {
  Sheet next = sheet();
  next.overall_steps.reset();
  next.notAssessableReason.clear();
  next.comment.clear();
  bool anything = sheet().overall_steps || !sheet().notAssessableReason.empty() || !sheet().comment.empty();
  for (SheetRow& row : next.rows) {
    anything = anything || row.score_steps || !row.notAssessableReason.empty();
    row = {row.code, {}, {}};
  }
  return anything && apply(std::move(next), {SheetChange::Kind::kAllCleared, kOverallRow}, false);
}

bool SheetEditor::setComment(const std::string& comment) {
  if (sheet().comment == comment) {
    return false;
  }
  Sheet next = sheet();
  next.comment = comment;
  return apply(std::move(next), {SheetChange::Kind::kComment, kOverallRow}, true);
}

std::optional<SheetChange> SheetEditor::undoable() const {
  return canUndo() ? std::optional(states_[at_].change) : std::nullopt;
}

std::optional<SheetChange> SheetEditor::redoable() const {
  return canRedo() ? std::optional(states_[at_ + 1].change) : std::nullopt;
}

bool SheetEditor::undo() {
  if (!canUndo()) {
    return false;
  }
  --at_;
  states_[at_].open = false;  // the next keystroke starts a new step
  return true;
}

bool SheetEditor::redo() {
  if (!canRedo()) {
    return false;
  }
  ++at_;
  return true;
}

void SheetEditor::saved(std::int64_t revision) {
  for (State& state : states_) {
    state.sheet.revision = revision;
  }
}

std::optional<std::int64_t> stepsForDigit(const ScoreScale& scale, int digit,
                                          std::optional<std::int64_t> typed_points) {
  TORSIO_EXPECTS(digit >= 0 && digit <= 9);
  const auto within = [&scale](std::int64_t points) -> std::optional<std::int64_t> {
    const std::int64_t steps = points * scale.stepsPerPoint;
    return isOnScale(steps, scale) ? std::optional(steps) : std::nullopt;
  };
  if (typed_points && *typed_points > 0) {
    if (const auto longer = within(*typed_points * 10 + digit)) {
      return longer;
    }
  }
  if (digit == 0 && !within(0)) {
    return within(10);
  }
  return within(digit);
}

std::int64_t arrowSteps(const ScoreScale& scale) noexcept {
  return scale.stepsPerPoint % 2 == 0 ? scale.stepsPerPoint / 2 : 1;
}

}  // namespace torsio
