// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/rating/rubric_repository.h"

#include <utility>

#include "assessment/domain/rating/mark.h"
#include "db/connection/row_reader.h"

namespace torsio {

namespace {

/// Reads the rows of a rubric joined with their anchors.
std::vector<RubricLine> rowsOf(Connection& connection, const RubricRevisionId& revisionId) {
  Statement statement = connection.prepare(
      "SELECT r.row_code, r.label, r.scale_lo_steps, r.scale_hi_steps, r.steps_per_point,"
      " r.weight_milli, a.score_steps, a.meaning FROM rubric_row r"
      " LEFT JOIN rubric_anchor a ON a.revision_id = r.revision_id AND a.row_code = r.row_code"
      " WHERE r.revision_id = ? ORDER BY r.position, a.score_steps");
  statement.execute({revisionId});
  std::vector<RubricLine> rows;
  while (statement.step()) {
    RowReader row(statement);
    RubricLine line{row.text(), row.text(), {row.int64(), row.int64(), row.int64()}, {}, row.int64()};
    if (rows.empty() || rows.back().code != line.code) {
      rows.push_back(std::move(line));
    }
    if (!row.nextIsNull()) {
      rows.back().anchors.push_back({row.int64(), row.text()});
    }
  }
  return rows;
}

}  // namespace

void RubricRepository::addRubric(const std::string& id, const std::string& name, std::int64_t createdUtc_us,
                                 bool demonstration) {
  connection_.execute(insertInto("rubric", "id, name, created_utc_us, demonstration"),
                      {id, name, createdUtc_us, demonstration});
}

std::vector<Rubric> RubricRepository::rubrics() const {
  return selectAll(connection_, "SELECT id, name, created_utc_us, demonstration FROM rubric ORDER BY name",
                   {}, [](RowReader& row) {
                     return Rubric{row.text(), row.text(), row.int64(), row.boolean()};
                   });
}

void RubricRepository::addRevision(const RubricRevision& revision) {
  validateScale(revision.overall);
  for (const RubricLine& row : revision.rows) {
    validateScale(row.scale);
  }
  Transaction transaction(connection_);
  connection_.execute(
      insertInto("rubric_revision",
                 "id, rubric_id, number, note, scale_lo_steps, scale_hi_steps, steps_per_point, created_by,"
                 " created_utc_us"),
      {revision.id, revision.rubricId, revision.number, revision.note, revision.overall.lo,
       revision.overall.hi, revision.overall.stepsPerPoint, revision.createdBy, revision.createdUtc_us});
  Statement insert = connection_.prepare(
      insertInto("rubric_row",
                 "revision_id, row_code, position, label, scale_lo_steps, scale_hi_steps, steps_per_point,"
                 " weight_milli"));
  Statement anchor =
      connection_.prepare(insertInto("rubric_anchor", "revision_id, row_code, score_steps, meaning"));
  std::int64_t position = 0;
  for (const RubricLine& row : revision.rows) {
    insert.execute({revision.id, row.code, ++position, row.label, row.scale.lo, row.scale.hi,
                    row.scale.stepsPerPoint, row.weight_milli});
    for (const RubricAnchor& part : row.anchors) {
      anchor.execute({revision.id, row.code, part.score_steps, part.meaning});
    }
  }
  transaction.commit();
}

std::optional<RubricRevision> RubricRepository::revision(const RubricRevisionId& revisionId) const {
  return selectFirst(
      connection_,
      "SELECT id, rubric_id, number, note, scale_lo_steps, scale_hi_steps, steps_per_point, created_by,"
      " created_utc_us FROM rubric_revision WHERE id = ?",
      {revisionId}, [&](RowReader& row) {
        return RubricRevision{.id = row.text(),
                              .rubricId = row.text(),
                              .number = row.int64(),
                              .note = row.text(),
                              .overall = {row.int64(), row.int64(), row.int64()},
                              .rows = rowsOf(connection_, revisionId),
                              .createdBy = row.text(),
                              .createdUtc_us = row.int64()};
      });
}

std::vector<RubricRevisionId> RubricRepository::revisionIds(const RubricId& rubricId) const {
  return selectAll(connection_, "SELECT id FROM rubric_revision WHERE rubric_id = ? ORDER BY number",
                   {rubricId}, readId<RubricRevisionId>);
}

}  // namespace torsio
