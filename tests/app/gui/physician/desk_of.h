// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

#include <QApplication>
#include <QTest>

#include "app/gui/base/translated_text.h"
#include "app/gui/physician/case_page.h"
#include "app/gui/physician/replay_panel.h"
#include "app/gui/physician/sheet_editor_panel.h"
#include "app/gui/widgets/child.h"
#include "tests/app/gui/support/watched_shell.h"
#include "tests/app/support/review_centre.h"

namespace torsio::gui {

/// The sheet of a page that scores a case.
inline const SheetEditor* editorOf(const QWidget& page) {
  return child<SheetEditorPanel>(page, "sheetPanel").editor();
}

/// A physician's desk with one page at a time; opens the pages that a page requests.
class DeskOf {
 public:
  DeskOf(torsio::testing::ReviewCentre& centre, std::size_t index)
      : session_(centre.physician(index)), watched_(*session_) {}

  template <class T>
  T& open(const QVariant& argument = {}) {
    page_.reset();
    auto made = std::make_unique<T>(shell());
    T& page = *made;
    page_ = std::move(made);
    page_->retranslate();
    page_->applyTheme(theme(ThemeKind::kLight));
    page_->resize(1146, 700);  // 1366 x 768 without navigation and header
    page_->show();
    page_->activateWindow();
    QApplication::processEvents();
    page_->enter(argument);
    shell().waitForJobs();
    return page;
  }
  /// Opens the last requested page; false: none, or not a case.
  bool follow() {
    if (wanted().empty()) {
      return false;
    }
    const auto [id, argument] = wanted().back();
    wanted().clear();
    if (id != PageId::kCase) {
      return false;
    }
    page_->enter(argument);
    shell().waitForJobs();
    return true;
  }
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QWidget* target = page_->focusWidget() != nullptr ? page_->focusWidget() : page_.get();
    QTest::keyClick(target, key, modifiers);
  }
  void press(std::initializer_list<Qt::Key> keys) {
    for (const Qt::Key key : keys) {
      press(key);
    }
  }
  /// Presses Ctrl+Enter.
  void finish(int times) {
    for (int i = 0; i < times; ++i) {
      press(Qt::Key_Return, Qt::ControlModifier);
    }
  }
  void type(const QString& text) {
    QWidget* target = page_->focusWidget() != nullptr ? page_->focusWidget() : page_.get();
    QTest::keyClicks(target, text);
  }
  /// Destroys the page without leave() or save: for the page, a crash.
  void drop() { page_.reset(); }

  [[nodiscard]] SessionContext& session() {
    session_->beginCall();
    return *session_;
  }
  [[nodiscard]] ShellContext& shell() { return watched_.shell(); }
  [[nodiscard]] Page& page() { return *page_; }
  /// What the pages report and request.
  [[nodiscard]] testing::WatchedShell& watched() { return watched_; }
  [[nodiscard]] const QStringList& failures() const { return watched_.failures; }
  [[nodiscard]] const QStringList& notices() const { return watched_.notices; }
  [[nodiscard]] std::vector<std::pair<PageId, QVariant>>& wanted() { return watched_.wanted; }

 private:
  std::unique_ptr<SessionContext> session_;
  testing::WatchedShell watched_;
  std::unique_ptr<Page> page_;
};

inline Qt::Key digit(int value) {
  return static_cast<Qt::Key>(Qt::Key_0 + value);
}

inline void watchAll(ReplayPanel& replay) {
  for (int i = 0; i < 100 && replay.playing(); ++i) {
    replay.frame(0.1);
  }
}

/// Scores the open case with three digits, watches it, and submits, using keys only.
inline void scoreCase(DeskOf& desk, int time, int accuracy, int overall) {
  auto& page = static_cast<CasePage&>(desk.page());
  child<ReplayPanel>(page, "replay").setRealTime(false);
  desk.press({digit(time), Qt::Key_Down, digit(accuracy), Qt::Key_Tab, digit(overall), Qt::Key_Space});
  watchAll(child<ReplayPanel>(page, "replay"));
  desk.finish(2);
}

inline QString inputOf(const std::string& id) {
  return toQString(id);
}

}  // namespace torsio::gui
