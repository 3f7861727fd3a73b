// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/simulator/pointer_keys.h"

#include <algorithm>

#include <QDialog>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

#include "app/gui/simulator/detorsion_panel.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

namespace {

constexpr int kColumns = 2;

QString settingOf(const PointerKeys::Movement& movement) {
  return QStringLiteral("keys/") + QLatin1String(movement.id);
}

int keyIn(const QKeySequence& sequence) {
  return sequence.isEmpty() ? 0 : sequence[0].toCombined() & ~static_cast<int>(Qt::KeyboardModifierMask);
}

}  // namespace

const std::array<PointerKeys::Movement, PointerKeys::kMovements>& PointerKeys::movements() {
  static constexpr std::array<Movement, kMovements> kAll{{{"left", Qt::Key_Left},
                                                          {"right", Qt::Key_Right},
                                                          {"up", Qt::Key_Up},
                                                          {"down", Qt::Key_Down},
                                                          {"deeper", Qt::Key_PageUp},
                                                          {"nearer", Qt::Key_PageDown},
                                                          {"twist-left", Qt::Key_Q},
                                                          {"twist-right", Qt::Key_E},
                                                          {"tilt-left", Qt::Key_A},
                                                          {"tilt-right", Qt::Key_D},
                                                          {"tilt-up", Qt::Key_W},
                                                          {"tilt-down", Qt::Key_S},
                                                          {"grip", Qt::Key_Space},
                                                          {"keep-grip", Qt::Key_G},
                                                          {"bookmark", Qt::Key_B}}};
  return kAll;
}

QString PointerKeys::nameOf(std::size_t movement) {
  const std::array<QString, kMovements> names{
      tr("Move left"),           tr("Move right"),      tr("Move up"),
      tr("Move down"),           tr("Move deeper"),     tr("Move nearer"),
      tr("Twist anticlockwise"), tr("Twist clockwise"), tr("Tilt left"),
      tr("Tilt right"),          tr("Tilt up"),         tr("Tilt down"),
      tr("Grip while held"),     tr("Keep the grip"),   tr("Set a bookmark")};
  return names.at(movement);
}

PointerKeys::PointerKeys() : keys_() {
  std::transform(movements().begin(), movements().end(), keys_.begin(),
                 [](const Movement& movement) { return movement.usual; });
}

bool PointerKeys::assign(std::size_t movement, int key) {
  if (key == 0) {
    return false;
  }
  for (std::size_t other = 0; other < kMovements; ++other) {
    if (other != movement && keys_[other] == key) {
      return false;
    }
  }
  keys_[movement] = key;
  return true;
}

int PointerKeys::usualFor(int pressed) const {
  const auto found = std::find(keys_.begin(), keys_.end(), pressed);
  if (found != keys_.end()) {
    return movements()[static_cast<std::size_t>(found - keys_.begin())].usual;
  }
  const bool usualElsewhere =
      std::any_of(movements().begin(), movements().end(),
                  [pressed](const Movement& movement) { return movement.usual == pressed; });
  return usualElsewhere ? 0 : pressed;
}

PointerKeys PointerKeys::stored() {
  PointerKeys keys;
  const QSettings settings;
  std::array<int, kMovements> wanted{};
  for (std::size_t movement = 0; movement < kMovements; ++movement) {
    bool number = false;
    const int key = settings.value(settingOf(movements()[movement])).toInt(&number);
    wanted[movement] = number && key > 0 ? key : keys.keys_[movement];
  }
  std::array<int, kMovements> sorted = wanted;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end()) {
    keys.keys_ = wanted;
  }
  return keys;
}

void PointerKeys::store() const {
  QSettings settings;
  for (std::size_t movement = 0; movement < kMovements; ++movement) {
    settings.setValue(settingOf(movements()[movement]), keys_[movement]);
  }
}

bool askPointerKeys(QWidget* parent) {
  PointerKeys keys = PointerKeys::stored();
  QDialog dialog(parent);
  dialog.setWindowTitle(PointerKeys::tr("Keys of the instrument"));
  auto* column = new QVBoxLayout(&dialog);
  column->setContentsMargins(3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace);
  column->setSpacing(2 * kSpace);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(2 * kSpace);
  column->addLayout(grid);
  auto* problem = new QLabel(&dialog);
  problem->setProperty("caution", true);
  column->addWidget(problem);
  std::vector<QKeySequenceEdit*> fields;
  const auto show = [&fields, &keys] {
    for (std::size_t i = 0; i < fields.size(); ++i) {
      fields[i]->setKeySequence(QKeySequence(keys.keyOf(i)));
    }
  };
  for (std::size_t i = 0; i < PointerKeys::kMovements; ++i) {
    auto* field = new QKeySequenceEdit(&dialog);
    field->setObjectName(QLatin1String(PointerKeys::movements()[i].id));
    field->setAccessibleName(PointerKeys::nameOf(i));
    auto* label = new QLabel(PointerKeys::nameOf(i), &dialog);
    label->setBuddy(field);
    const int row = static_cast<int>(i) / kColumns;
    const int place = static_cast<int>(i) % kColumns * 2;
    grid->addWidget(label, row, place);
    grid->addWidget(field, row, place + 1);
    fields.push_back(field);
    QObject::connect(field, &QKeySequenceEdit::editingFinished, &dialog, [&keys, &show, field, problem, i] {
      const bool taken = !keys.assign(i, keyIn(field->keySequence()));
      problem->setText(taken ? PointerKeys::tr("That key moves something else already.") : QString());
      show();
    });
  }
  show();
  auto* buttons = new QDialogButtonBox(&dialog);
  buttons->addButton(PointerKeys::tr("Save"), QDialogButtonBox::AcceptRole);
  buttons->addButton(PointerKeys::tr("Cancel"), QDialogButtonBox::RejectRole);
  QPushButton* usual = buttons->addButton(PointerKeys::tr("Usual keys"), QDialogButtonBox::ResetRole);
  QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  QObject::connect(usual, &QPushButton::clicked, &dialog, [&keys, &show] {
    keys = PointerKeys();
    show();
  });
  column->addWidget(buttons);
  if (dialog.exec() != QDialog::Accepted) {
    return false;
  }
  keys.store();
  return true;
}

std::vector<std::pair<QString, QString>> PointerKeys::help() {
  std::vector<std::pair<QString, QString>> all{
      {tr("Move the instrument"), tr("Mouse, or arrow keys")},
      {tr("Depth"), tr("Wheel, or Page Up and Page Down")},
      {tr("Grip"), tr("Left button or Space (hold), G (keep)")},
      {tr("Twist what is held"), tr("Drag, Shift + wheel, or Q and E")},
      {tr("Tilt the instrument"), tr("A, D, W, S")},
      {tr("Release"), tr("Release the button, or Esc")},
      {tr("Bookmark"), tr("B")},
      {tr("Turn the view"), tr("Right drag, or Ctrl + arrow keys")},
      {tr("Move the view"), tr("Middle drag")},
      {tr("Zoom"), tr("Ctrl + wheel, or + and \u2212")},
  };
  for (auto& key : DetorsionPanel::keys()) {
    all.push_back(std::move(key));
  }
  return all;
}

void showPointerKeys(QWidget* parent) {
  QString text = QStringLiteral("<table cellspacing='6'>");
  for (const auto& [what, how] : PointerKeys::help()) {
    text +=
        QStringLiteral("<tr><td style='padding-right:24px'><b>%1</b></td><td>%2</td></tr>").arg(what, how);
  }
  text += QStringLiteral("</table>");
  QMessageBox box(QMessageBox::NoIcon, PointerKeys::tr("Controls"), text, QMessageBox::Close, parent);
  box.setTextFormat(Qt::RichText);
  box.exec();
}

}  // namespace torsio::gui
