// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QElapsedTimer>

#include "app/gui/base/page.h"
#include "app/gui/physician/sheet_editor_panel.h"
#include "app/services/review/case_remarks.h"
#include "app/services/review/case_sheet.h"
#include "app/services/review/sheet_editor.h"

class QFrame;
class QLabel;
class QLineEdit;
class QPushButton;
class QSplitter;
class QToolButton;
class QVBoxLayout;

namespace torsio::gui {

class ReplayPanel;
class SheetEditorPanel;

/// A case: recording on the left, sheet on the right. Every keystroke is stored immediately; submitting asks
/// for confirmation and then seals. Argument of enter(): the assignment id.
class CasePage : public Page {
  Q_OBJECT

 public:
  explicit CasePage(ShellContext& shell, QWidget* parent = nullptr);
  ~CasePage() override;

  void enter(const QVariant& argument) override;
  [[nodiscard]] bool leave() override;
  [[nodiscard]] std::vector<std::pair<QString, QString>> keys() const override;
  void retranslate() override;
  void applyTheme(const Theme& theme) override;

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void customEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void createHead(QVBoxLayout* column);
  QWidget* createStrip();
  void load();
  void edited();
  void save();
  void keepWatched();
  void addBookmark(const QString& text);
  void askRemark();
  /// Opens the field with one's own remark; empty `id`: the one nearest to the playhead.
  void editRemark(const RemarkId& id);
  /// Stores the field as a new remark or as the edited one.
  void storeRemark();
  void askSubmit();
  void submit();
  void startAmending();
  void finishAmending();
  void showAll();
  void showCheck();
  void showHistory();
  /// Returns when and why each version was sealed, one per line.
  [[nodiscard]] QString versionsText() const;
  void showRemarks();
  [[nodiscard]] QString rowName(const std::string& row) const;
  [[nodiscard]] QString stepName(const SheetChange& change) const;
  [[nodiscard]] QString checkText(const SheetCheck& check) const;
  void noteWork();

  QLabel* title_;
  QLabel* facts_;
  SaidLine saved_;
  QToolButton* undo_;
  QToolButton* redo_;
  QToolButton* clear_;
  QToolButton* advance_;
  QPushButton* amend_;
  QPushButton* submit_;
  QSplitter* halves_;
  ReplayPanel* replay_;
  SheetEditorPanel* sheet_;
  QLabel* remarks_;
  QLineEdit* remarkField_;
  QToolButton* bookmark_;
  QToolButton* remark_;
  QFrame* strip_;
  QLabel* stripText_;
  QLineEdit* stripReason_;
  QPushButton* stripGo_;
  QPushButton* stripBack_;

  OpenedSheet opened_;
  ViewingRules rules_;
  WatchLog watched_;
  WatchLog kept_;  // what counts of it so far
  std::vector<CaseRemark> caseRemarks_;
  RemarkId edited_;  ///< remark being edited; empty: a new one
  std::vector<SheetVersion> versions_;
  QElapsedTimer sinceKey_;
  std::uint64_t loads_ = 0;
  bool amending_ = false;
  bool sealed_ = false;  ///< the previous case has just been sealed here
};

}  // namespace torsio::gui
