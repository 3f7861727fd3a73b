// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <QDialog>
#include <QString>

#include "app/services/access/second_factor.h"

class QLabel;
class QLineEdit;
class QStackedWidget;
class QVBoxLayout;

namespace torsio::gui {

/// Asks for the code of an account whose password fits; empty: given up. `wrong`: why the last one was
/// refused; empty: it is the first. GUI thread.
[[nodiscard]] std::optional<QString> askCode(QWidget* parent, const QString& wrong);

/// Sets up a second factor: the picture for an authenticator app, its first code, then the recovery codes.
/// GUI thread; the check takes about half a second.
class SecondFactorDialog : public QDialog {
  Q_OBJECT

 public:
  /// Stores what was entered and returns the recovery codes. Throws Error.
  using SwitchOn =
      std::function<std::vector<std::string>(const std::string& password, const std::string& code)>;

  /// `why`: why the dialog is there. `asksPassword`: it is not known from the sign-in.
  SecondFactorDialog(const SecondFactorOffer& offer, const QString& why, bool asksPassword, SwitchOn switchOn,
                     QWidget* parent = nullptr);

 private:
  QWidget* createSetUp(const SecondFactorOffer& offer, const QString& why, bool asksPassword);
  QWidget* createCodes();
  void submit();
  void showCodes(const std::vector<std::string>& codes);

  SwitchOn switchOn_;
  QStackedWidget* steps_;
  QLineEdit* password_ = nullptr;  // null: not asked for
  QLineEdit* code_ = nullptr;
  QLabel* answer_ = nullptr;
  QLabel* codes_ = nullptr;
};

/// Says that the user's second factor is on, and switches it off. GUI thread.
class SecondFactorStateDialog : public QDialog {
  Q_OBJECT

 public:
  /// Throws Error.
  using SwitchOff = std::function<void(const std::string& password, const std::string& code)>;

  SecondFactorStateDialog(const OwnSecondFactor& own, SwitchOff switchOff, QWidget* parent = nullptr);

 private:
  void submit();

  SwitchOff switchOff_;
  QLineEdit* password_;
  QLineEdit* code_;
  QLabel* answer_;
};

}  // namespace torsio::gui
