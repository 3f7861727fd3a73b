// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include <QString>
#include <QTimer>
#include <QWidget>

#include "app/gui/base/language.h"
#include "app/services/maintenance/station_anchor.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace torsio::gui {

/// What an administrator takes along when signing out: length, time and hash of the audit trail's head, where
/// it was stored, and a copy button. Hidden until there is one.
class HeadNotice : public QWidget {
  Q_OBJECT

 public:
  explicit HeadNotice(QWidget* parent = nullptr);

  void tell(const LeftHead& head);
  void forget();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void retranslate();

  LeftHead head_;
  QLabel* heading_;
  QLabel* facts_;
  QLabel* hash_;
  QLabel* where_;
  QPushButton* copy_;
};

/// The first screen: sign in with a password for one's own work, or with a station PIN or as a guest for
/// unrecorded practice. Keeps no secret longer than the attempt.
class SignInPanel : public QWidget {
  Q_OBJECT

 public:
  explicit SignInPanel(QWidget* parent = nullptr);

  void setCentre(const QString& name);
  /// Shows a message under the button: wrong password, account disabled, signed out when idle. Empty: none.
  void say(const QString& sentence, bool caution);
  /// After too many failures: counts down and blocks further attempts. Microseconds since 1970 UTC.
  void waitUntil(std::int64_t utc_us, std::int64_t now_us);
  void setWorking(bool working);
  /// Shows the audit head that an administrator should take along after signing out, until clear(); empty:
  /// nothing changes.
  void tellHead(const std::optional<LeftHead>& head);
  /// Shows an unobtrusive way out for administrators.
  void setKiosk(bool kiosk);
  /// Sets whether cards can be scanned or their codes typed here.
  void setCards(bool cards);
  /// Clears name, password and message for the next person.
  void clear();

 Q_SIGNALS:
  void passwordGiven(const QString& login, const QString& password);
  void pinGiven(const QString& login, const QString& pin);
  /// A code was entered, by scanner or by hand.
  void codeGiven(const QString& code);
  void guestChosen();
  void leaveKioskWanted();
  void languageWanted(torsio::gui::Language language);

 protected:
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
