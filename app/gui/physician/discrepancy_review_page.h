// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <QWidget>

#include "app/gui/base/page.h"
#include "app/gui/widgets/theme.h"
#include "app/services/review/discrepancy_review.h"
#include "app/services/review/sheet_editor.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace torsio::gui {

class ComparisonBars;
class DataTable;
class PageHeading;
class SheetEditorPanel;

/// After everybody has submitted: one's own discrepant marks, and the decision about each. Shows only
/// disagreements, and no names.
class DiscrepancyReviewPage : public Page {
  Q_OBJECT

 public:
  explicit DiscrepancyReviewPage(ShellContext& shell, QWidget* parent = nullptr);
  ~DiscrepancyReviewPage() override;

  void enter(const QVariant& argument) override;
  [[nodiscard]] std::vector<std::pair<QString, QString>> keys() const override;
  void retranslate() override;
  void applyTheme(const Theme& theme) override;

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  [[nodiscard]] const DiscrepancyCase* current() const;
  void connectAll();
  void read();
  void showList();
  void showCase();
  void startMoving();
  void stopMoving();
  /// False: shows the error at the field and focuses it.
  [[nodiscard]] bool hasReason();
  template <typename Action>
  void decide(const Action& action, const QString& said);

  PageHeading* heading_;
  DataTable* table_;
  QWidget* right_;
  QLabel* case_;
  QLabel* state_;
  QLabel* legend_;
  ComparisonBars* bars_;
  SheetEditorPanel* sheet_;
  QLineEdit* reason_;
  QLabel* why_;  ///< error of the reason
  QPushButton* keep_;
  QPushButton* move_;
  QPushButton* adjudicator_;
  QPushButton* replay_;
  QLabel* empty_;
  Text opens_{};  ///< when cases are compared
  std::vector<DiscrepancyCase> cases_;
  std::string chosen_;  ///< assignment id
};

/// One's own marks against the others' range and mean, one bar per row: a band from lowest to highest, a line
/// at the mean, a diamond at the own mark; discrepant rows are also described in words.
class ComparisonBars : public QWidget {
  Q_OBJECT

 public:
  explicit ComparisonBars(QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  void setRows(std::vector<RowComparison> rows);
  void retranslate() { describe(); }
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] int rowHeight() const;
  void drawRow(QPainter& painter, const RowComparison& row, const QRect& area) const;
  [[nodiscard]] QString sentenceOf(const RowComparison& row) const;
  void describe();

  const Theme* theme_;
  std::vector<RowComparison> rows_;
};

}  // namespace torsio::gui
