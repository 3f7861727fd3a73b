// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/people/consent_repository.h"

#include <cstdint>

#include "db/connection/row_reader.h"

namespace torsio {

namespace {

std::vector<ConsentWords> wordsOf(Connection& connection, const std::string& versionId) {
  Statement statement = connection.prepare(
      "SELECT language, purpose, title, words FROM consent_text WHERE version_id = ?"
      " ORDER BY language, position");
  statement.execute({versionId});
  std::vector<ConsentWords> languages;
  while (statement.step()) {
    RowReader row(statement);
    const std::string language = row.text();
    if (languages.empty() || languages.back().language != language) {
      languages.push_back({language, {}});
    }
    languages.back().texts.push_back({row.text(), row.text(), row.text()});
  }
  return languages;
}

}  // namespace

std::vector<std::string> ConsentRepository::purposes() const {
  return selectAll(connection_, "SELECT code FROM consent_purpose ORDER BY position, code", {}, readText);
}

void ConsentRepository::addPurpose(const std::string& code) {
  connection_.execute(
      "INSERT INTO consent_purpose (code, position)"
      " VALUES (?, (SELECT COALESCE(MAX(p.position), 0) + 1 FROM consent_purpose p))",
      {code});
}

std::vector<ConsentVersion> ConsentRepository::versions() const {
  return selectAll(
      connection_,
      "SELECT id, number, note, published_by, published_utc_us FROM consent_version ORDER BY number", {},
      [this](RowReader& row) {
        ConsentVersion version;
        version.id = row.text();
        version.number = row.int64();
        version.note = row.text();
        version.publishedBy = row.text();
        version.publishedUtc_us = row.int64();
        version.languages = wordsOf(connection_, version.id);
        return version;
      });
}

void ConsentRepository::add(const ConsentVersion& version) {
  Transaction transaction(connection_);
  connection_.execute(
      insertInto("consent_version", "id, number, note, published_by, published_utc_us"),
      {version.id, version.number, version.note, version.publishedBy, version.publishedUtc_us});
  Statement insert = connection_.prepare(
      insertInto("consent_text", "version_id, language, purpose, position, title, words"));
  for (const ConsentWords& words : version.languages) {
    std::int64_t position = 0;
    for (const ConsentText& text : words.texts) {
      insert.execute({version.id, words.language, text.purpose, ++position, text.title, text.text});
    }
  }
  transaction.commit();
}

}  // namespace torsio
