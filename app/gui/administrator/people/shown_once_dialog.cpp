// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/people/shown_once_dialog.h"

#include <utility>

#include <QApplication>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "sim/core/error.h"

namespace torsio::gui {

namespace {

constexpr QSize kShownOnceSize(720, 520);

}  // namespace

ShownOnceDialog::ShownOnceDialog(const QString& title, const QString& words, const QString& fileName,
                                 QWidget* parent)
    : QDialog(parent),
      fileName_(fileName),
      table_(new DataTable(QString(), this)),
      copy_(new QPushButton(tr("&Copy"), this)),
      cards_(new QPushButton(tr("Save c&ards (PDF)\u2026"), this)) {
  setWindowTitle(title);
  resize(kShownOnceSize);
  QLabel* said = sentence(this);
  said->setText(words);
  auto* buttons = new QDialogButtonBox(this);
  buttons->addButton(cards_, QDialogButtonBox::ActionRole);
  buttons->addButton(copy_, QDialogButtonBox::ActionRole);
  buttons->addButton(tr("Done"), QDialogButtonBox::RejectRole)->setAutoDefault(false);
  cards_->setDefault(true);
  cards_->setFocus();
  connect(cards_, &QPushButton::clicked, this, &ShownOnceDialog::askCards);
  connect(copy_, &QPushButton::clicked, this, &ShownOnceDialog::copy);
  connect(buttons, &QDialogButtonBox::rejected, this, &ShownOnceDialog::reject);
  QVBoxLayout* column = pageColumn(this);
  column->setSpacing(kSpace);
  column->addWidget(said);
  column->addWidget(table_, 1);
  column->addWidget(buttons);
}

void ShownOnceDialog::setLines(const std::vector<Column>& columns, std::vector<Row> rows) {
  table_->setColumns(columns);
  table_->setRows(std::move(rows));
}

QString ShownOnceDialog::linesAsText() const {
  table_->view().clearSelection();
  return table_->asText();
}

void ShownOnceDialog::copy() {
  QApplication::clipboard()->setText(copied());
  copy_->setText(tr("Copied"));
  taken_ = true;
}

void ShownOnceDialog::saveCards(const std::filesystem::path& file) {
  writeCards(file);
  cards_->setText(tr("Cards saved"));
  taken_ = true;
}

void ShownOnceDialog::askCards() {
  const QString file = askFileToSave(this, tr("Save cards"), fileName_, tr("PDF (*.pdf)"));
  if (file.isEmpty()) {
    return;
  }
  try {
    saveCards(toPath(file));
  } catch (const Error& error) {
    QMessageBox::warning(this, tr("Save cards"), translatedLine(error));
  }
}

void ShownOnceDialog::reject() {
  if (!taken_ && QMessageBox::question(this, windowTitle(),
                                       tr("Nothing was copied or saved, and this is not shown again. Close "
                                          "all the same?")) != QMessageBox::Yes) {
    return;
  }
  QDialog::reject();
}

}  // namespace torsio::gui
