// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/base/page.h"
#include "app/services/review/review_queue.h"

class QGridLayout;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace torsio::gui {

class Card;
class DataTable;
class PageHeading;
class QuestionsCard;
class RepliesCard;

/// A physician's home page: amount of work, time needed, and one button to continue.
class QueuePage : public Page {
  Q_OBJECT

 public:
  explicit QueuePage(ShellContext& shell, QWidget* parent = nullptr);

  void enter(const QVariant& argument) override;
  void retranslate() override;

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Figure {
    Card* card;
    QLabel* figure;
    QLabel* words;
  };
  Figure addFigure(QHBoxLayout* row);
  void createDoors(QVBoxLayout* outer);
  void showQueue();
  void showFigures();
  void showDoors();
  void goOn();

  PageHeading* heading_;
  QPushButton* continue_;
  Figure waiting_;
  Figure drafts_;
  Figure time_;
  Figure due_;
  struct Door {
    QLabel* text;
    QPushButton* button;
    QWidget* row;
  };
  Card* doors_;
  QGridLayout* doorPlaces_;
  QuestionsCard* questions_;
  RepliesCard* replies_;
  Door calibration_;
  Door live_;
  Door discrepancies_;
  Door evaluation_;
  DataTable* table_;
  ReviewQueue queue_;
};

}  // namespace torsio::gui
