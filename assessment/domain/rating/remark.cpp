// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/domain/rating/remark.h"

#include "sim/core/error.h"

namespace torsio {

RemarkRevision revisionOf(const Remark& remark, const std::string& author, const PersonId& authorPersonId,
                          const std::string& text, std::int64_t now_us) {
  const bool own =
      remark.author == author || (!authorPersonId.empty() && remark.authorPersonId == authorPersonId);
  if (!own) {
    throw Error(ErrorCode::kPermission, Text::tr("somebody else wrote this remark"), remark.id,
                Text::tr("Edit one of your own"));
  }
  if (remark.text.empty()) {
    refuseParameter(Text::tr("this remark has no words"), remark.id, Text::tr("Write a new one"));
  }
  if (text.find_first_not_of(" \t\n") == std::string::npos) {
    refuseParameter(Text::tr("the new words are missing"), remark.id,
                    Text::tr("Write what you want to say; a remark is not taken away"));
  }
  if (text == remark.text) {
    refuseParameter(Text::tr("the words are the same"), remark.id,
                    Text::tr("Change them, or leave the remark as it is"));
  }
  return {.remarkId = remark.id,
          .version = remark.version + 1,
          .author = author,
          .authorPersonId = authorPersonId,
          .text = text,
          .createdUtc_us = now_us};
}

std::string revisionNote(const RemarkRevision& revision) {
  return "{\"version\":" + std::to_string(revision.version) + "}";
}

}  // namespace torsio
