// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <QString>
#include <QTimer>
#include <QWidget>

#include "app/gui/base/language.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace torsio {
struct LeftHead;
}

namespace torsio::gui {

class HeadNotice;

/// The first thing that anybody sees: who are you? With the password one reaches one's own work; with a
/// station PIN, or as a guest, practice that is not recorded. Holds no secret longer than the try.
class SignInPanel : public QWidget {
  Q_OBJECT

 public:
  explicit SignInPanel(QWidget* parent = nullptr);

  void setCentre(const QString& name);
  /// A quiet sentence under the button: wrong, disabled, signed out after idling. Empty: nothing.
  void say(const QString& sentence, bool caution);
  /// Too many wrong tries: says how long, counts down, and lets nobody try before. Microseconds since 1970
  /// UTC.
  void waitUntil(std::int64_t utc_us, std::int64_t now_us);
  void setWorking(bool working);
  /// What an administrator who has just left should take along, until clear().
  void tellHead(const LeftHead& head);
  /// A quiet way out for administrators.
  void setKiosk(bool kiosk);
  /// Whether a card can be held to a scanner here, or its code typed.
  void setCards(bool cards);
  /// For the next person: no name, no password, no sentence.
  void clear();

 Q_SIGNALS:
  void passwordGiven(const QString& login, const QString& password);
  void pinGiven(const QString& login, const QString& pin);
  /// What a scanner typed, with Enter behind it, or a hand.
  void codeGiven(const QString& code);
  void guestChosen();
  void leaveKioskWanted();
  void languageWanted(torsio::gui::Language language);

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* createForm();
  void setPinMode(bool pin);
  void submit();
  void chooseField();
  void countDown();
  void enableForm();
  void retranslate();
  [[nodiscard]] static Language otherLanguage();

  bool pinMode_ = false;
  bool working_ = false;
  int wait_s_ = 0;
  QTimer second_;
  QLabel* centre_;
  QLabel* heading_;
  QLabel* loginLabel_;
  QLabel* secretLabel_;
  QLabel* codeLabel_;
  QLineEdit* code_;
  QLineEdit* login_;
  QLineEdit* secret_;
  QPushButton* enter_;
  QLabel* answer_;
  HeadNotice* head_;
  QPushButton* mode_;
  QPushButton* guest_;
  QLabel* guestNote_;
  QLabel* tool_;
  QPushButton* leaveKiosk_;
  QPushButton* language_;
};

}  // namespace torsio::gui
