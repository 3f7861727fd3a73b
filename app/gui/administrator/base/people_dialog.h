// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <QDialog>

#include "app/services/people/people_service.h"

namespace torsio::gui {

class DataTable;

/// Selects people from a list; initially all are selected.
class PeopleDialog : public QDialog {
  Q_OBJECT

 public:
  PeopleDialog(const QString& title, const QString& question, const std::vector<PersonRow>& people,
               QWidget* parent);

  [[nodiscard]] std::vector<PersonId> chosen() const;

 private:
  DataTable* table_;
};

}  // namespace torsio::gui
