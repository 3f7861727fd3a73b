// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <QLabel>
#include <QString>
#include <QWidget>

#include "app/gui/physician/sheet_panel.h"
#include "app/gui/widgets/form.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/sheet.h"

class QKeyEvent;
class QButtonGroup;
class QHBoxLayout;

namespace torsio::gui {

class SaidLine;
class ShellContext;

/// A sheet being filled in: rubric, undo history, keys, save status, and a second press before sealing. Used
/// on every page with marks; the page decides where the sheet is stored and what follows. GUI thread.
class SheetEditorPanel : public SheetPanel {
  Q_OBJECT

 public:
  /// `largeTargets`: buttons of at least 44 pixels, for fingers.
  explicit SheetEditorPanel(bool largeTargets = false, QWidget* parent = nullptr);
  ~SheetEditorPanel() override;

  /// Shows a sheet with a new history. `withOverall`: false for forms without overall mark.
  void beginSheet(RubricRevision rubric, Sheet sheet, bool withOverall = true);
  /// Shows nothing.
  void endSheet();
  /// Returns the editor; null if no sheet is shown.
  [[nodiscard]] SheetEditor* editor() const noexcept { return editor_.get(); }

  /// Calls `store`; shows on `said` whether the sheet was saved, and reports an error.
  bool save(ShellContext& shell, SaidLine& said, std::function<QString()> kept,
            const std::function<void()>& store);
  /// Returns whether the last save() failed, so that the sheet is not stored.
  [[nodiscard]] bool unsaved() const noexcept { return unsaved_; }

  /// Undo or redo the last change; no effect on a read-only sheet.
  void undo();
  void redo();
  /// Clears all answers and the comment as one undo step.
  void clearAll();
  /// Handles undo, redo, and Ctrl+Enter, which requests the page's final action. False: another key.
  bool handleCommand(QKeyEvent* event);
  /// Calls handleCommand(), then handles the keys of the rows.
  bool handle(QKeyEvent* event);

  /// Returns whether the page has asked for a second press. Any change of the sheet withdraws the question.
  [[nodiscard]] bool asking() const noexcept { return asking_; }
  void setAsking(bool asking) noexcept { asking_ = asking; }

  /// Suppresses Ctrl+Enter after the previous sheet was sealed, until something else is done here. Ended by
  /// beginSheet() and touched().
  void waitForTouch() noexcept { awaitsTouch_ = true; }
  void touched() noexcept { awaitsTouch_ = false; }

 Q_SIGNALS:
  /// Ctrl+Enter was pressed, without auto-repeat.
  void finishWanted();
  /// Ctrl+Enter was suppressed by waitForTouch().
  void heldBack();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  std::unique_ptr<SheetEditor> editor_;
  bool asking_ = false;
  bool unsaved_ = false;
  bool awaitsTouch_ = false;
};

/// A page's status message; again() repeats it in the present language. The label belongs to its parent. GUI
/// thread.
class SaidLine {
 public:
  explicit SaidLine(QLabel* label) : label_(label) {}

  /// `words` returns the sentence in the present language. `caution`: it needs action.
  void say(std::function<QString()> words, bool caution = false) {
    words_ = std::move(words);
    setLook(label_, "caution", caution);
    again();
  }
  void clear() { say({}); }
  void again() { label_->setText(words_ ? words_() : QString()); }
  [[nodiscard]] QLabel* label() const noexcept { return label_; }

 private:
  QLabel* label_;
  std::function<QString()> words_;
};

/// A row of alternatives, one of which is selected: models of an evaluation, reference runs of a calibration.
/// GUI thread.
class ChoiceRow : public QWidget {
  Q_OBJECT

 public:
  explicit ChoiceRow(QWidget* parent = nullptr);

  /// Replaces the buttons; `chosen` is selected, none if out of range. Emits nothing.
  void setChoices(const std::vector<QString>& texts, std::size_t chosen);

 Q_SIGNALS:
  /// A button was pressed; its index.
  void chosen(std::size_t position);

 private:
  QHBoxLayout* row_;
  QButtonGroup* group_;
};

}  // namespace torsio::gui
