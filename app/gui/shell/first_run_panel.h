// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QString>
#include <QWidget>

#include "app/gui/base/language.h"
#include "app/gui/shell/visit_bar.h"
#include "app/services/access/first_run.h"

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

/// What the wizard was told.
struct FirstRunChoice {
  FirstRun first;
  QString locator;  ///< of the database
};

/// The first start of a centre, in four short steps: language and centre, first administrator, database,
/// demonstration cohort. Nothing is made before the last button; the start passwords of the demonstration are
/// shown once.
class FirstRunPanel : public QWidget {
  Q_OBJECT

 public:
  /// `defaultFile`: where an embedded database would lie.
  explicit FirstRunPanel(const QString& defaultFile, QWidget* parent = nullptr);
  ~FirstRunPanel() override;

  [[nodiscard]] JobPanel& job() noexcept { return *job_; }
  void setLanguage(Language language);
  void setWorking(bool working);
  /// After success: the accounts with their start passwords, once. Without any the panel is done at once.
  void showAccounts(const std::vector<StartAccount>& accounts);
  /// The language that is chosen here.
  [[nodiscard]] Language language() const;
  /// Under the buttons: what is missing, or what went wrong.
  void say(const QString& sentence);

 Q_SIGNALS:
  void languageWanted(torsio::gui::Language language);
  void chosen(const torsio::gui::FirstRunChoice& choice);
  void done();
  /// Nothing is to be set up: only a look at what a centre looks like.
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
  /// Enter in a field that is no line of text.
  void nextOnEnter(QWidget* field);
  /// What is missing in the present step, and in which field; no sentence: nothing.
  struct Gap {
    QString sentence;
    QWidget* field = nullptr;
  };
  [[nodiscard]] Gap missing() const;
  /// Says it right below its field, where the keyboard goes.
  void sayAt(const Gap& gap);
  [[nodiscard]] QString locator() const;
  void chooseFile();
  void testDatabase();
  void showEngine();
  void retranslate();
  void retranslateDatabase();

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
