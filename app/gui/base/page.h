// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include <QString>
#include <QVariant>
#include <QWidget>

#include "app/gui/base/page_id.h"
#include "app/services/access/operation.h"

namespace torsio {
class SessionContext;
}

namespace torsio::gui {

class ShellContext;
struct Theme;

/// One place of the navigation: a trainee's "Next step", a physician's "Queue", the administrator's "Roster".
/// Pages hold no logic: they show what services of app give them, through ShellContext::session(). Texts are
/// set in retranslate(), colours that the style sheet does not give in applyTheme(); both are called after
/// construction and whenever language or theme change.
class Page : public QWidget {
  Q_OBJECT

 public:
  /// Lists on the page keep their columns for each role: the property "role" says whose page it is.
  explicit Page(ShellContext& shell, QWidget* parent = nullptr);

  /// Shown, possibly again: reads anew what it shows. `argument`: what the caller of ShellContext::open gave.
  virtual void enter(const QVariant& argument) { static_cast<void>(argument); }
  /// About to be left or closed. False: something must be finished first (the page has said what).
  [[nodiscard]] virtual bool leave() { return true; }
  /// True while a scored run goes on: no idle lock, no sign-out, no other page.
  [[nodiscard]] virtual bool busy() const { return false; }
  /// Keys that are no commands of a menu or button, for the sheet on F1: what and how.
  [[nodiscard]] virtual std::vector<std::pair<QString, QString>> keys() const { return {}; }
  virtual void retranslate() = 0;
  virtual void applyTheme(const Theme& theme) { static_cast<void>(theme); }

 protected:
  [[nodiscard]] ShellContext& shell() const noexcept { return shell_; }
  void changeEvent(QEvent* event) override;

 private:
  ShellContext& shell_;
};

/// How the shell makes a page; what else it knows of the page stands in the table of page_id.h.
struct PageEntry {
  PageId id;
  std::function<Page*(ShellContext&)> make;
};

/// One picture of the user guide: a page in a state that is worth showing, on the demonstration cohort.
struct ScreenEntry {
  QString name;  ///< of the file, without language, theme, size and ending: "station-debrief"
  QString role;  ///< "trainee", "rater", "administrator": who is signed in
  PageId pageId;
  std::function<QVariant(SessionContext&)> argument;  ///< for Page::enter; may be empty
  std::function<void(Page&)> prepare;                 ///< after enter(); may be empty
};

}  // namespace torsio::gui
