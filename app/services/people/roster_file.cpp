// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a roster and guesses what its columns mean; roster_import.cpp imports it.
#include <algorithm>
#include <cstdint>
#include <map>
#include <system_error>
#include <utility>

#include "app/services/people/roster_import.h"
#include "app/services/people/roster_text.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio {

namespace {

struct FieldName {
  RosterField field;
  const char* code;
  const char* example;
};
constexpr std::array<FieldName, kRosterFields> kFields{
    {{RosterField::kExternalId, "external_id", "S-1001"},
     {RosterField::kFullName, "full_name", "Maria Example"},
     {RosterField::kEmail, "email", "maria@example.org"},
     {RosterField::kSex, "sex", "female"},
     {RosterField::kLevel, "level", "master's student"},
     {RosterField::kExperience, "experience", "none"},
     {RosterField::kAge, "age", "24"},
     {RosterField::kHandedness, "handedness", "right"},
     {RosterField::kRaterClass, "rater_class", "chief"}}};

/// Lower case without spaces, dashes, underscores and dots, so that "E-Mail" and "e_mail" match.
std::string plain(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (std::string_view(" \t-_./'()").find(c) != std::string_view::npos) {
      continue;
    }
    result.push_back(c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c);
  }
  return result;
}

const std::map<std::string, RosterField>& knownHeaders() {
  static const std::map<std::string, RosterField> kKnown = [] {
    const std::vector<std::pair<RosterField, std::vector<const char*>>> names{
        {RosterField::kExternalId,
         {"externalid", "id", "staffid", "staffnumber", "staffno", "studentid", "studentnumber", "studentno",
          "employeeid", "employeenumber", "personnelnumber", "badge", "number", "工号", "学号", "编号",
          "职工号"}},
        {RosterField::kFullName, {"fullname", "name", "traineename", "ratername", "person", "姓名", "名字"}},
        {RosterField::kEmail, {"email", "mail", "emailaddress", "邮箱", "电子邮箱", "电子邮件"}},
        {RosterField::kSex, {"sex", "gender", "性别"}},
        {RosterField::kLevel,
         {"level", "grade", "degree", "year", "trainingyear", "pgy", "学历", "年级", "级别"}},
        {RosterField::kExperience,
         {"experience", "priorexperience", "surgicalexperience", "经验", "手术经验"}},
        {RosterField::kAge, {"age", "ageyears", "年龄"}},
        {RosterField::kHandedness, {"handedness", "hand", "dominanthand", "利手", "惯用手"}},
        {RosterField::kRaterClass,
         {"raterclass", "class", "rank", "title", "position", "职称", "职务", "类别"}}};
    std::map<std::string, RosterField> known;
    for (const auto& [field, headers] : names) {
      for (const char* header : headers) {
        known.emplace(header, field);
      }
    }
    return known;
  }();
  return kKnown;
}

}  // namespace

std::string_view rosterFieldCode(RosterField field) noexcept {
  return kFields[static_cast<std::size_t>(field)].code;
}

Phrase rosterFieldLabel(RosterField field) noexcept {
  switch (field) {
    case RosterField::kExternalId:
      return Text::tr("Staff or student number");
    case RosterField::kFullName:
      return Text::tr("Full name");
    case RosterField::kEmail:
      return Text::tr("E-mail");
    case RosterField::kSex:
      return Text::tr("Sex");
    case RosterField::kLevel:
      return Text::tr("Level");
    case RosterField::kExperience:
      return Text::tr("Experience");
    case RosterField::kAge:
      return Text::tr("Age");
    case RosterField::kHandedness:
      return Text::tr("Handedness");
    case RosterField::kRaterClass:
      return Text::tr("Class of rater");
  }
  return {};
}

std::vector<RosterField> rosterFields(RosterKind kind) {
  std::vector<RosterField> fields{RosterField::kExternalId, RosterField::kFullName};
  if (kind == RosterKind::kRaters) {
    fields.push_back(RosterField::kRaterClass);
  }
  fields.insert(fields.end(), {RosterField::kEmail, RosterField::kSex, RosterField::kLevel,
                               RosterField::kExperience, RosterField::kAge});
  if (kind == RosterKind::kTrainees) {
    fields.push_back(RosterField::kHandedness);
  }
  return fields;
}

bool isRequired(RosterField field, RosterKind kind) noexcept {
  return field == RosterField::kExternalId || field == RosterField::kFullName ||
         (field == RosterField::kRaterClass && kind == RosterKind::kRaters);
}

std::string rosterTemplate(RosterKind kind) {
  std::string header = "\xEF\xBB\xBF";
  std::string line;
  for (const RosterField field : rosterFields(kind)) {
    const FieldName& name = kFields[static_cast<std::size_t>(field)];
    header.append(line.empty() ? "" : ",").append(name.code);
    line.append(line.empty() ? "" : ",").append(name.example);
  }
  return header + "\r\n" + line + "\r\n";
}

RosterFile readRoster(const std::filesystem::path& file) {
  constexpr std::uintmax_t kLargest_bytes = 16U << 20U;  // 80,000 people with all fields filled
  std::error_code unknown;
  if (const std::uintmax_t size = std::filesystem::file_size(file, unknown);
      !unknown && size > kLargest_bytes) {
    refuse(Text::tr("is larger than %1 MiB, which no roster is", kLargest_bytes >> 20U),
           file.filename().string(), Text::tr("Choose the list of the people, or divide it"));
  }
  return parseRoster(readFile(file), file.filename().string());
}

RosterFile parseRoster(std::string_view bytes, const std::string& name) {
  const RosterText decoded = decodeRosterText(bytes, name);
  const std::string& text = decoded.utf8;
  RosterFile roster;
  roster.name = name;
  roster.encoding = decoded.encoding;
  roster.separator = guessSeparator(text);
  roster.rows = csvRecords(text, name, roster.separator);
  std::erase_if(roster.rows, [](const CsvRecord& row) {
    return std::all_of(row.values.begin(), row.values.end(), [](const std::string& value) {
      return value.find_first_not_of(" \t") == std::string::npos;
    });
  });
  if (roster.rows.empty()) {
    refuse(Text::tr("the roster is empty"), name, Text::tr("Begin with a line that names the columns"));
  }
  const std::size_t headerLine = roster.rows.front().line;
  roster.header = std::move(roster.rows.front().values);
  roster.rows.erase(roster.rows.begin());
  for (auto column = roster.header.begin(); column != roster.header.end(); ++column) {
    if (column->empty() || std::find(roster.header.begin(), column, *column) == column) {
      continue;
    }
    refuse(Text::tr("two columns are called \"%1\"", *column), Text::tr("%1, line %2", name, headerLine),
           Text::tr("Give each column a name of its own"));
  }
  if (roster.rows.empty()) {
    refuse(Text::tr("the roster has a header but nobody in it"), name, Text::tr("Add one line a person"));
  }
  Digest digest;
  digest.update(bytes);
  roster.contentHash = digest.hex();
  return roster;
}

RosterColumns suggestColumns(const RosterFile& file, RosterKind kind) {
  const std::vector<RosterField> wanted = rosterFields(kind);
  RosterColumns columns{};
  for (std::size_t column = 0; column < file.header.size(); ++column) {
    const auto known = knownHeaders().find(plain(file.header[column]));
    if (known == knownHeaders().end()) {
      continue;
    }
    if (std::find(wanted.begin(), wanted.end(), known->second) == wanted.end()) {
      continue;
    }
    std::optional<std::size_t>& place = columns[static_cast<std::size_t>(known->second)];
    if (!place) {
      place = column;
    }
  }
  return columns;
}

}  // namespace torsio
