// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QString>
#include <QWidget>

#include "app/gui/base/language.h"
#include "app/gui/shell/simulated_desks.h"
#include "app/services/access/first_run.h"
#include "sim/core/text.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QRadioButton;
class QStackedWidget;
class QVBoxLayout;

namespace torsio::gui {

class Background;
class JobPanel;

/// The wizard's result.
struct FirstRunChoice {
  FirstRun first;
  QString locator;  ///< of the database
};

/// The first start of a centre in four short steps: language and centre, first administrator, database,
/// demonstration cohort. Nothing is created before the last button; the demonstration's start passwords are
/// shown once.
class FirstRunPanel : public QWidget {
  Q_OBJECT

 public:
  /// `place`: file or address of the database. `setBy`: file and line that set it for this computer; empty:
  /// it may be changed.
  FirstRunPanel(const QString& place, Text setBy, QWidget* parent = nullptr);
  ~FirstRunPanel() override;

  [[nodiscard]] JobPanel& job() noexcept { return *job_; }
  void setLanguage(Language language);
  void setWorking(bool working);
  /// Shows the accounts with their start passwords once after success. Without any, the panel finishes
  /// immediately.
  void showAccounts(const std::vector<StartAccount>& accounts);
  /// Returns the chosen language.
  [[nodiscard]] Language language() const;
  /// Shows a problem under the buttons.
  void say(const QString& sentence);

 Q_SIGNALS:
  void languageWanted(torsio::gui::Language language);
  void chosen(const torsio::gui::FirstRunChoice& choice);
  void done();
  /// The user only wants to look at a demonstration, without setup.
  void lookRoundWanted(VisitedDesk desk);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QWidget* createCentreStep();
  QWidget* createAdministratorStep();
  QWidget* createDatabaseStep();
  QWidget* createDemonstrationStep();
  QWidget* createAccountsStep();
  void go(int step);
  void next();
  /// Makes Enter continue in a field that is not a line edit.
  void nextOnEnter(QWidget* field);
  /// What is missing in the present step, and its field; empty sentence: nothing.
  struct Gap {
    QString sentence;
    QWidget* field = nullptr;
  };
  [[nodiscard]] Gap missing() const;
  /// Shows it below its field, and focuses the field.
  void sayAt(const Gap& gap);
  [[nodiscard]] QString locator() const;
  void chooseFile();
  void testDatabase();
  void showPlace(const QString& place);
  void showEngine();
  void retranslate();
  void retranslateDatabase();

  Text setBy_;
  Background* background_;
  QStackedWidget* steps_;
  JobPanel* job_;
  QLabel* step_;
  QLabel* heading_;
  QLabel* why_;
  QLabel* answer_;
  QVBoxLayout* answerPlace_ = nullptr;
  QPushButton* back_;
  QPushButton* next_;
  QLabel* look_ = nullptr;
  QPushButton* lookTrainee_ = nullptr;
  QPushButton* lookPhysician_ = nullptr;
  QPushButton* lookAdministrator_ = nullptr;
  QLabel* lookNote_ = nullptr;
  bool working_ = false;

  QLabel* languageLabel_ = nullptr;
  QComboBox* language_ = nullptr;
  QLabel* centreLabel_ = nullptr;
  QLineEdit* centre_ = nullptr;

  QLabel* loginLabel_ = nullptr;
  QLineEdit* login_ = nullptr;
  QLabel* passwordLabel_ = nullptr;
  QLineEdit* password_ = nullptr;
  QLabel* againLabel_ = nullptr;
  QLineEdit* again_ = nullptr;

  QRadioButton* file_ = nullptr;
  QLabel* fileNote_ = nullptr;
  QLineEdit* path_ = nullptr;
  QPushButton* choose_ = nullptr;
  QRadioButton* server_ = nullptr;
  QLabel* serverNote_ = nullptr;
  QLineEdit* address_ = nullptr;
  QPushButton* test_ = nullptr;

  QRadioButton* without_ = nullptr;
  QLabel* withoutNote_ = nullptr;
  QRadioButton* with_ = nullptr;
  QLabel* withNote_ = nullptr;

  QLabel* accounts_ = nullptr;
  QPushButton* copy_ = nullptr;
};

}  // namespace torsio::gui
