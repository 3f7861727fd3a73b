// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/second_factor_dialog.h"

#include <utility>

#include <QApplication>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPixmap>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/services/access/qr_code.h"
#include "sim/core/error.h"

namespace torsio::gui {

namespace {

constexpr int kFactorWidth = 480;
constexpr int kModule_px = 5;
constexpr int kQuietModules = 4;  // zone around a QR code
constexpr int kSecretGroup = 4;

/// Black on white in every theme: phones expect it.
QPixmap picture(const std::string& text) {
  const auto dark = qrCode(text).dark;
  const int side = static_cast<int>(dark.size()) + 2 * kQuietModules;
  QImage image(side, side, QImage::Format_RGB32);
  image.fill(Qt::white);
  for (std::size_t row = 0; row < dark.size(); ++row) {
    for (std::size_t column = 0; column < dark.size(); ++column) {
      if (dark[row][column]) {
        image.setPixelColor(static_cast<int>(column) + kQuietModules, static_cast<int>(row) + kQuietModules,
                            Qt::black);
      }
    }
  }
  return QPixmap::fromImage(image.scaled(side * kModule_px, side * kModule_px));
}

QString grouped(const std::string& secret) {
  QString text = toQString(secret);
  for (auto at = text.size() - kSecretGroup; at > 0; at -= kSecretGroup) {
    text.insert(at, QLatin1Char(' '));
  }
  return text;
}

QLabel* typeable(QWidget* parent, const char* name) {
  auto* label = named(new QLabel(parent), name);
  label->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  return label;
}

QVBoxLayout* dialogColumn(QWidget* owner) {
  QVBoxLayout* column = columnOf(owner, QMargins(3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace), kSpace);
  owner->setMinimumWidth(kFactorWidth);
  return column;
}

QLabel* refusalLine(QWidget* parent) {
  QLabel* line = named(sentence(parent, false), "wrong");
  setLook(line, "caution", true);
  line->hide();
  return line;
}

/// Runs `act` and returns an empty text, or says why not.
template <typename Act>
QString refusalOf(const Act& act) {
  QApplication::setOverrideCursor(Qt::WaitCursor);
  QString refusal;
  try {
    act();
  } catch (const Error& error) {
    refusal = translatedLine(error);
  }
  QApplication::restoreOverrideCursor();
  return refusal;
}

/// Says below the fields why not, and selects the code to be typed again.
void sayRefusal(QDialog& dialog, QLabel& line, QLineEdit& code, const QString& refusal) {
  line.setText(refusal);
  line.show();
  growToSentences(&dialog);
  code.selectAll();
  code.setFocus();
}

class CodeDialog : public QDialog {
  Q_DECLARE_TR_FUNCTIONS(CodeDialog)

 public:
  CodeDialog(QWidget* parent, const QString& wrong)
      : QDialog(parent), code_(named(new QLineEdit(this), "code")) {
    setObjectName(QStringLiteral("codeDialog"));
    setWindowTitle(tr("Second factor"));
    QVBoxLayout* column = dialogColumn(this);
    column->addWidget(sentence(
        this, tr("Your password is right. Type the six digits that your authenticator app shows now.")));
    nameField(addField(column, code_), tr("&Code from your app, or a recovery code"));
    QLabel* answer = refusalLine(this);
    answer->setText(wrong);
    answer->setVisible(!wrong.isEmpty());
    column->addWidget(answer);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    QPushButton* go = named(buttons->addButton(tr("&Sign in"), QDialogButtonBox::AcceptRole), "signIn");
    go->setProperty("primary", true);
    go->setDefault(true);
    const auto whetherTyped = [this, go] { go->setEnabled(!code_->text().trimmed().isEmpty()); };
    connect(code_, &QLineEdit::textChanged, this, whetherTyped);
    whetherTyped();
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    column->addWidget(buttons);
    code_->setFocus();
  }
  [[nodiscard]] QString code() const { return code_->text().trimmed(); }

 private:
  QLineEdit* code_;
};

}  // namespace

std::optional<QString> askCode(QWidget* parent, const QString& wrong) {
  CodeDialog dialog(parent, wrong);
  return dialog.exec() == QDialog::Accepted ? std::optional(dialog.code()) : std::nullopt;
}

SecondFactorDialog::SecondFactorDialog(const SecondFactorOffer& offer, const QString& why, bool asksPassword,
                                       SwitchOn switchOn, QWidget* parent)
    : QDialog(parent), switchOn_(std::move(switchOn)), steps_(new QStackedWidget(this)) {
  setObjectName(QStringLiteral("secondFactorDialog"));
  setWindowTitle(tr("Second factor"));
  auto* column = bareLayout<QVBoxLayout>(this, 0);
  column->addWidget(steps_);
  steps_->addWidget(createSetUp(offer, why, asksPassword));
  steps_->addWidget(createCodes());
  (password_ != nullptr ? password_ : code_)->setFocus();
}

QWidget* SecondFactorDialog::createSetUp(const SecondFactorOffer& offer, const QString& why,
                                         bool asksPassword) {
  auto* page = new QWidget(this);
  QVBoxLayout* column = dialogColumn(page);
  column->addWidget(sentence(page, why, false));
  column->addWidget(sentence(
      page, tr("Scan this picture with an authenticator app on your phone, or type the secret into it.")));
  auto* code = named(new QLabel(page), "qrCode");
  code->setPixmap(picture(offer.uri));
  code->setAccessibleName(tr("QR code of the secret"));
  column->addWidget(code, 0, Qt::AlignHCenter);
  QLabel* secret = typeable(page, "secret");
  secret->setText(grouped(offer.secret));
  secret->setAccessibleName(tr("Secret"));
  column->addWidget(secret, 0, Qt::AlignHCenter);
  QPushButton* copy = linkButton(page);
  copy->setText(tr("Copy as an &address (otpauth)"));
  connect(copy, &QPushButton::clicked, this,
          [uri = toQString(offer.uri)] { QGuiApplication::clipboard()->setText(uri); });
  column->addWidget(copy, 0, Qt::AlignHCenter);
  if (asksPassword) {
    password_ = named(secretField(page), "password");
    nameField(addField(column, password_), tr("Your &password"));
  }
  code_ = named(new QLineEdit(page), "code");
  nameField(addField(column, code_), tr("The six &digits that the app shows now"));
  answer_ = refusalLine(page);
  column->addWidget(answer_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, page);
  QPushButton* on = named(buttons->addButton(tr("&Switch on"), QDialogButtonBox::AcceptRole), "switchOn");
  on->setProperty("primary", true);
  on->setDefault(true);
  connect(buttons, &QDialogButtonBox::accepted, this, &SecondFactorDialog::submit);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(buttons);
  return page;
}

QWidget* SecondFactorDialog::createCodes() {
  auto* page = new QWidget(this);
  QVBoxLayout* column = dialogColumn(page);
  auto* heading = new QLabel(tr("Recovery codes"), page);
  heading->setProperty("subheading", true);
  column->addWidget(heading);
  column->addWidget(sentence(
      page, tr("The second factor is on. Without your phone, each of these codes signs you in once. They are "
               "shown only now: print them or write them down, and keep them away from this computer.")));
  codes_ = typeable(page, "recoveryCodes");
  column->addWidget(codes_, 0, Qt::AlignHCenter);
  column->addStretch(1);
  auto* buttons = new QDialogButtonBox(page);
  QPushButton* copy = buttons->addButton(tr("&Copy"), QDialogButtonBox::ActionRole);
  connect(copy, &QPushButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(codes_->text()); });
  QPushButton* taken =
      named(buttons->addButton(tr("I have &taken them down"), QDialogButtonBox::AcceptRole), "taken");
  taken->setProperty("primary", true);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  column->addWidget(buttons);
  return page;
}

void SecondFactorDialog::submit() {
  const std::string password = password_ == nullptr ? "" : password_->text().toStdString();
  const std::string code = code_->text().trimmed().toStdString();
  if (code.empty() || (password_ != nullptr && password.empty())) {
    (code.empty() ? code_ : password_)->setFocus();
    return;
  }
  std::vector<std::string> codes;
  const QString refusal = refusalOf([&] { codes = switchOn_(password, code); });
  if (refusal.isEmpty()) {
    showCodes(codes);
    return;
  }
  sayRefusal(*this, *answer_, *code_, refusal);
}

void SecondFactorDialog::showCodes(const std::vector<std::string>& codes) {
  QStringList lines;
  for (const std::string& code : codes) {
    lines << toQString(code);
  }
  codes_->setText(lines.join(QLatin1Char('\n')));
  steps_->setCurrentIndex(1);
}

SecondFactorStateDialog::SecondFactorStateDialog(const OwnSecondFactor& own, SwitchOff switchOff,
                                                 QWidget* parent)
    : QDialog(parent),
      switchOff_(std::move(switchOff)),
      password_(named(secretField(this), "password")),
      code_(named(new QLineEdit(this), "code")),
      answer_(refusalLine(this)) {
  setObjectName(QStringLiteral("secondFactorState"));
  setWindowTitle(tr("Second factor"));
  QVBoxLayout* column = dialogColumn(this);
  column->addWidget(
      sentence(this, tr("It is on. Recovery codes not used yet: %1.").arg(own.recoveryCodes), false));
  column->addWidget(sentence(
      this, own.asked ? tr("The centre asks you for it: after switching it off, the next sign-in sets it up "
                           "again, on another phone for example.")
                      : tr("For another phone, or for new recovery codes, switch it off and on again.")));
  nameField(addField(column, password_), tr("Your &password"));
  nameField(addField(column, code_), tr("&Code from your app, or a recovery code"));
  column->addWidget(answer_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  QPushButton* off = named(buttons->addButton(tr("&Switch off"), QDialogButtonBox::AcceptRole), "switchOff");
  const auto whetherTyped = [this, off] {
    off->setEnabled(!password_->text().isEmpty() && !code_->text().trimmed().isEmpty());
  };
  for (QLineEdit* field : {password_, code_}) {
    connect(field, &QLineEdit::textChanged, this, whetherTyped);
  }
  whetherTyped();
  connect(buttons, &QDialogButtonBox::accepted, this, &SecondFactorStateDialog::submit);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(buttons);
  password_->setFocus();
}

void SecondFactorStateDialog::submit() {
  const QString refusal =
      refusalOf([&] { switchOff_(password_->text().toStdString(), code_->text().trimmed().toStdString()); });
  if (refusal.isEmpty()) {
    accept();
    return;
  }
  sayRefusal(*this, *answer_, *code_, refusal);
}

}  // namespace torsio::gui
