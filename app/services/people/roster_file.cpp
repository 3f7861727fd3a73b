// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a roster and guesses what its columns mean; roster_import.cpp imports it.
#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <QByteArray>
#include <QByteArrayView>
#include <QString>
#include <QStringDecoder>

#include "app/services/people/roster_import.h"
#include "sim/core/byte_order_mark.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio {

namespace {

/// Text of a file saved by a spreadsheet.
struct RosterText {
  std::string utf8{};      ///< without a byte order mark
  std::string encoding{};  ///< encoding of the file: "UTF-8", "UTF-16", "GB18030", "Windows-1252"
};

/// Converts to UTF-8; empty if the text is not in this encoding, or the system does not know it.
std::optional<std::string> decoded(std::string_view bytes, const char* encoding) {
  QStringDecoder decoder(encoding,
                         QStringConverter::Flag::Stateless);  // an incomplete character at the end is an
                                                              // error
  if (!decoder.isValid()) {
    return std::nullopt;
  }
  const QString text = decoder(QByteArrayView(bytes.data(), static_cast<qsizetype>(bytes.size())));
  // Undefined bytes become C1 control characters.
  const bool meaningless = std::any_of(text.begin(), text.end(), [](QChar letter) {
    return letter == QChar::ReplacementCharacter || (letter >= QChar(0x80) && letter <= QChar(0x9F));
  });
  if (decoder.hasError() || meaningless) {
    return std::nullopt;
  }
  return text.toStdString();
}

/// Simplified Chinese consists of pairs of bytes above A0; in a western text such bytes are single among
/// ASCII letters.
bool isPairedChinese(std::string_view bytes) {
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const auto byte = [&](std::size_t at) {
      return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0U;
    };
    if (byte(i) < 0x80) {
      continue;
    }
    if (byte(i) < 0xA1 || byte(i + 1) < 0xA1) {
      return false;
    }
    ++pairs;
    ++i;
  }
  return pairs > 0;
}

/// Decodes UTF-8, UTF-16 with a byte order mark ("Unicode text"), and what older spreadsheets save: GB18030
/// if all non-ASCII characters are byte pairs as in simplified Chinese, otherwise Windows-1252. `name`: file
/// name for messages. Throws Error{kBadData} for any other encoding.
RosterText decodeRosterText(std::string_view bytes, const std::string& name) {
  const bool little = bytes.starts_with("\xFF\xFE");
  if (little || bytes.starts_with("\xFE\xFF")) {
    if (auto text = decoded(bytes.substr(2), little ? "UTF-16LE" : "UTF-16BE")) {
      return {std::move(*text), "UTF-16"};
    }
    refuse(Text::tr("the text begins as UTF-16 and is broken"), name,
           Text::tr("Save the table as UTF-8 CSV"));
  }
  bytes = withoutByteOrderMark(bytes);
  if (auto text = decoded(bytes, "UTF-8")) {
    return {std::move(*text), "UTF-8"};
  }
  for (const char* encoding : {"GB18030", "windows-1252"}) {
    if (encoding == std::string_view("GB18030") && !isPairedChinese(bytes)) {
      continue;
    }
    if (auto text = decoded(bytes, encoding)) {
      return {std::move(*text), encoding == std::string_view("GB18030") ? "GB18030" : "Windows-1252"};
    }
  }
  refuse(Text::tr("the text is in no encoding that a spreadsheet saves"), name,
         Text::tr("Save the table as UTF-8 CSV"));
}

struct FieldName {
  RosterField field;
  const char* code;
  const char* example;
  Phrase label;
};
constexpr std::array<FieldName, kRosterFields> kFields{
    {{RosterField::kExternalId, "external_id", "S-1001", Text::tr("Staff or student number")},
     {RosterField::kFullName, "full_name", "Maria Example", Text::tr("Full name")},
     {RosterField::kEmail, "email", "maria@example.org", Text::tr("E-mail")},
     {RosterField::kSex, "sex", "female", Text::tr("Sex")},
     {RosterField::kLevel, "level", "master's student", Text::tr("Level")},
     {RosterField::kExperience, "experience", "none", Text::tr("Experience")},
     {RosterField::kAge, "age", "24", Text::tr("Age")},
     {RosterField::kHandedness, "handedness", "right", Text::tr("Handedness")},
     {RosterField::kRaterClass, "rater_class", "chief", Text::tr("Class of rater")}}};

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
  return kFields[static_cast<std::size_t>(field)].label;
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
  std::string header(kByteOrderMark);
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
           Text::tr("Give each column a different name"));
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
