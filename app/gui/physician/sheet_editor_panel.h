// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "app/gui/physician/sheet_panel.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/sheet.h"

class QKeyEvent;

namespace torsio::gui {

class SaidLine;
class ShellContext;

/// A sheet while somebody fills it in: the rubric, its one history for undo and redo, its keys, what is said
/// about saving, and the second press before it is sealed. Every page on which marks are given has one; the
/// page says where a sheet is kept and what follows. GUI thread.
class SheetEditorPanel : public SheetPanel {
  Q_OBJECT

 public:
  /// `largeTargets`: buttons of at least 44 pixels, for fingers.
  explicit SheetEditorPanel(bool largeTargets = false, QWidget* parent = nullptr);
  ~SheetEditorPanel() override;

  /// Shows a sheet and begins a new history. `withOverall`: false for forms of rows alone.
  void beginSheet(RubricRevision rubric, Sheet sheet, bool withOverall = true);
  /// Shows nothing.
  void endSheet();
  /// Null when no sheet is shown.
  [[nodiscard]] SheetEditor* editor() const noexcept { return editor_.get(); }

  /// Does `store`; says on `said` that the sheet is kept, or that it is not, and reports why.
  bool save(ShellContext& shell, SaidLine& said, std::function<QString()> kept,
            const std::function<void()>& store);
  /// The last save() failed: what is shown is kept nowhere yet.
  [[nodiscard]] bool unsaved() const noexcept { return unsaved_; }

  /// Take back the last change, or bring it again; nothing on a sheet that is read only.
  void undo();
  void redo();
  /// Takes every answer and the comment away, as one step that undo() brings back.
  void clearAll();
  /// Undo, redo, and Ctrl+Enter, which asks for what the page does at the end. False: none of these.
  bool handleCommand(QKeyEvent* event);
  /// handleCommand(), then the keys of the rows.
  bool handle(QKeyEvent* event);

  /// Whether the page has asked to press once more. A change of the sheet takes the question back.
  [[nodiscard]] bool asking() const noexcept { return asking_; }
  void setAsking(bool asking) noexcept { asking_ = asking; }

  /// The sheet took the place of one that was sealed just now: Ctrl+Enter belongs to that one until something
  /// else is done here. beginSheet() ends it, and so does touched().
  void waitForTouch() noexcept { awaitsTouch_ = true; }
  void touched() noexcept { awaitsTouch_ = false; }

 Q_SIGNALS:
  /// Ctrl+Enter; not while it is held down.
  void finishWanted();
  /// Ctrl+Enter that waitForTouch() kept back.
  void heldBack();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  std::unique_ptr<SheetEditor> editor_;
  bool asking_ = false;
  bool unsaved_ = false;
  bool awaitsTouch_ = false;
};

}  // namespace torsio::gui
