// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>

#include <QFrame>
#include <QString>
#include <QWidget>

#include "app/gui/base/translated_text.h"

class QLabel;
class QPlainTextEdit;
class QPushButton;

namespace torsio::gui {

struct Theme;

/// What went wrong and what to do, with folded details and a copy button. Stays until closed and follows the
/// language.
class ProblemPanel : public QFrame {
  Q_OBJECT

 public:
  explicit ProblemPanel(QWidget* parent = nullptr);

  void tell(const Problem& problem);
  /// Hides it, and shows it from now on over the upper edge of its parent instead of in a layout, so that it
  /// moves nothing under the pointer.
  void floatAtTop();
  /// Off for screens that show nothing else.
  void setClosable(bool closable);
  /// Returns the whole text, as copied by the button.
  [[nodiscard]] QString wholeText() const;
  void setTheme(const Theme& theme);
  void retranslate();

 protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void say();
  void showDetails(bool shown);
  void place();

  Problem problem_;
  bool floats_ = false;
  QLabel* sign_;
  QLabel* happened_;
  QLabel* remedy_;
  QPlainTextEdit* details_;
  QPushButton* fold_;
  QPushButton* copy_;
  QPushButton* close_;
};

/// Shown when the database cannot be used: what happened, what to do, and two ways to continue.
class TroublePanel : public QWidget {
  Q_OBJECT

 public:
  explicit TroublePanel(QWidget* parent = nullptr);
  void tell(const std::exception_ptr& problem);
  void setTheme(const Theme& theme);

 Q_SIGNALS:
  void retryWanted();
  void otherDatabaseWanted();

 private:
  void retranslate();
  ProblemPanel* problem_;
  QPushButton* retry_;
  QPushButton* other_;
};

}  // namespace torsio::gui
