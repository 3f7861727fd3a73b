// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/pdf/pdf_structure.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include <QPainter>
#include <QString>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <qpdf/QPDFWriter.hh>

#include "sim/core/error.h"

namespace torsio {

namespace {

using PdfObject = QPDFObjectHandle;

constexpr double kUpperEdge_mm = 297.0;
constexpr double kPointsPerMm = 72.0 / 25.4;
constexpr std::uint64_t kMark = 50'000'000;  // device units left of the page, where nothing else is drawn
constexpr char kMarkBegin[] = "\n-";
constexpr char kMarkEnd[] = "0 1 1 re\nf\n";

PdfObject pdfText(const QString& text) {
  return PdfObject::newUnicodeString(text.toStdString());
}

std::string uncompressed(PdfObject stream) {
  const std::shared_ptr<Buffer> data = stream.getStreamData();
  return {reinterpret_cast<const char*>(data->getBuffer()), data->getSize()};
}

void setContent(PdfObject stream, const std::string& content) {
  stream.replaceStreamData(content, PdfObject::newNull(), PdfObject::newNull());
}

void addDescription(QPDF& pdf, const PdfStructure& structure) {
  PdfObject catalog = pdf.getRoot();
  catalog.replaceKey("/Lang", PdfObject::newString(structure.language.toStdString()));
  catalog.replaceKey("/ViewerPreferences", PdfObject::parse("<</DisplayDocTitle true>>"));
  pdf.getTrailer().getKey("/Info").replaceKey("/Author", pdfText(structure.author));
  std::string xml = uncompressed(catalog.getKey("/Metadata"));
  const std::string title = "</dc:title>";
  const std::size_t at = xml.find(title);
  if (at == std::string::npos) {
    throw std::runtime_error("no title in the metadata");
  }
  xml.insert(at + title.size(),
             QStringLiteral("<dc:creator><rdf:Seq><rdf:li>%1</rdf:li></rdf:Seq></dc:creator>"
                            "<dc:language><rdf:Bag><rdf:li>%2</rdf:li></rdf:Bag></dc:language>")
                 .arg(structure.author.toHtmlEscaped(), structure.language.toHtmlEscaped())
                 .toStdString());
  setContent(catalog.getKey("/Metadata"), xml);
}

void addBookmarks(QPDF& pdf, const std::vector<PdfBookmark>& bookmarks) {
  if (bookmarks.empty()) {
    return;
  }
  const std::vector<PdfObject>& pages = pdf.getAllPages();
  PdfObject outlines = pdf.makeIndirectObject(PdfObject::parse("<</Type /Outlines>>"));
  PdfObject section;
  for (const PdfBookmark& mark : bookmarks) {
    const bool top = mark.level == 0 || !section.isInitialized();
    PdfObject parent = top ? outlines : section;
    const int top_pt = static_cast<int>((kUpperEdge_mm - mark.top_mm) * kPointsPerMm);
    PdfObject entry = pdf.makeIndirectObject(PdfObject::newDictionary(
        {{"/Title", pdfText(mark.title)},
         {"/Parent", parent},
         {"/Dest",
          PdfObject::newArray({pages.at(mark.page), PdfObject::newName("/XYZ"), PdfObject::newInteger(0),
                               PdfObject::newInteger(top_pt), PdfObject::newInteger(0)})}}));
    if (parent.hasKey("/Last")) {
      parent.getKey("/Last").replaceKey("/Next", entry);
      entry.replaceKey("/Prev", parent.getKey("/Last"));
    } else {
      parent.replaceKey("/First", entry);
    }
    parent.replaceKey("/Last", entry);
    const long long count = parent.hasKey("/Count") ? parent.getKey("/Count").getIntValue() : 0;
    parent.replaceKey("/Count", PdfObject::newInteger(count + (top ? 1 : -1)));  // negative: collapsed
                                                                                 // initially
    section = top ? entry : section;
  }
  pdf.getRoot().replaceKey("/Outlines", outlines);
  pdf.getRoot().replaceKey("/PageMode", PdfObject::newName("/UseOutlines"));
}

const char* structureName(PdfRole role) {
  switch (role) {
    case PdfRole::kSection:
      return "/H1";
    case PdfRole::kTitle:
      return "/H2";
    case PdfRole::kFigure:
      return "/Figure";
    case PdfRole::kHeaderCell:
      return "/TH";
    case PdfRole::kCell:
      return "/TD";
    case PdfRole::kArtifact:
    case PdfRole::kParagraph:
      break;
  }
  return "/P";
}

/// Parts found in a page's content stream, with their numbers on the page.
using FoundParts = std::map<std::size_t, std::size_t>;

/// Replaces the markers in a page's content stream by marked-content operators.
std::string taggedDrawing(const std::string& drawing, const std::vector<PdfPart>& parts, FoundParts& found) {
  std::string tagged;
  std::size_t from = 0;
  bool open = false;
  for (std::size_t at = drawing.find(kMarkBegin); at != std::string::npos;
       at = drawing.find(kMarkBegin, at + 1)) {
    char* after = nullptr;
    const std::uint64_t place = std::strtoull(drawing.c_str() + at + 2, &after, 10);
    const std::size_t end = drawing.find(kMarkEnd, static_cast<std::size_t>(after - drawing.c_str()));
    if (place < kMark || place - kMark >= parts.size() || end == std::string::npos ||
        end > static_cast<std::size_t>(after - drawing.c_str()) + 1) {
      continue;
    }
    const std::size_t part = place - kMark;
    tagged.append(drawing, from, at + 1 - from).append(open ? "EMC\n" : "");
    if (parts[part].role == PdfRole::kArtifact) {
      tagged += "/Artifact BMC\n";
    } else {
      const std::size_t number = found.size();
      tagged.append(structureName(parts[part].role)) += " <</MCID " + std::to_string(number) + ">> BDC\n";
      found[part] = number;
    }
    open = true;
    from = end + sizeof kMarkEnd - 1;
  }
  tagged.append(drawing, from);
  return open ? tagged + "\nEMC\n" : tagged;
}

/// Builds the structure tree.
class StructureTree {
 public:
  explicit StructureTree(QPDF& pdf) : pdf_(pdf) {}

  /// Returns the element. `number`: index of the part on its page.
  PdfObject add(const PdfPart& part, std::size_t number, const PdfObject& page) {
    PdfObject made = child(structureName(part.role), parentOf(part));
    made.replaceKey("/Pg", page);
    made.replaceKey("/K", PdfObject::newInteger(static_cast<long long>(number)));
    if (part.role == PdfRole::kFigure) {
      made.replaceKey("/Alt", pdfText(part.instead));
    }
    if (part.role == PdfRole::kHeaderCell) {
      made.replaceKey("/A", PdfObject::parse("<</O /Table /Scope /Column>>"));
    }
    return made;
  }

  /// `parents`: the elements of each page.
  void finish(const std::vector<PdfObject>& parents) {
    PdfObject numbers = PdfObject::newArray();
    for (std::size_t page = 0; page < parents.size(); ++page) {
      numbers.appendItem(PdfObject::newInteger(static_cast<long long>(page)));
      numbers.appendItem(parents[page]);
    }
    root_.replaceKey("/ParentTree", pdf_.makeIndirectObject(PdfObject::newDictionary({{"/Nums", numbers}})));
    root_.replaceKey("/ParentTreeNextKey", PdfObject::newInteger(static_cast<long long>(parents.size())));
    pdf_.getRoot().replaceKey("/MarkInfo", PdfObject::parse("<</Marked true>>"));
    pdf_.getRoot().replaceKey("/StructTreeRoot", root_);
  }

 private:
  PdfObject child(const char* name, PdfObject parent) {
    PdfObject made =
        pdf_.makeIndirectObject(PdfObject::newDictionary({{"/Type", PdfObject::newName("/StructElem")},
                                                          {"/S", PdfObject::newName(name)},
                                                          {"/P", parent},
                                                          {"/K", PdfObject::newArray()}}));
    parent.getKey("/K").appendItem(made);
    return made;
  }

  PdfObject parentOf(const PdfPart& part) {
    if (part.table == 0) {
      tableNumber_ = 0;
      return document_;
    }
    const bool newTable = part.table != tableNumber_;
    if (newTable) {
      table_ = child("/Table", document_);
    }
    if (newTable || part.row != rowNumber_) {
      row_ = child("/TR", table_);
    }
    tableNumber_ = part.table;
    rowNumber_ = part.row;
    return row_;
  }

  QPDF& pdf_;
  PdfObject root_ = pdf_.makeIndirectObject(PdfObject::parse("<</Type /StructTreeRoot /K []>>"));
  PdfObject document_ = child("/Document", root_);
  PdfObject table_;
  PdfObject row_;
  std::size_t tableNumber_ = 0;  // 0: none is open
  std::size_t rowNumber_ = 0;
};

// The character that each radical from U+2E80 to U+2EF3 looks like (Unicode: Equivalent_Unified_Ideograph).
constexpr char16_t kFirstRadical = 0x2E80;
constexpr std::u16string_view kLikeRadical =
    u"\u3000厂乛乚乙亻冂\u3000刀刂卜㔾小小兀尣尢\u3000巳幺彑彐忄心扌攵\u3000旡日月歺母民氵氺灬爫爫丬牛"
    u"犭王\u3000目示礻\u3000糹纟罓罒㓁冗\u3000羊\u3000\u3000耂肀聿肉\u3000艹艹艹虎衤覀西见角\u3000讠贝\u3000"
    u"车辶辶辶邑"
    u"钅長镸长门\u3000阝雨青韦页风飞食\u3000飠饣\u3000马骨鬼鱼鸟卤麦黄黾斉齐歯齿竜龙龜亀龟";

/// Returns the character that is drawn like a radical, or the character itself.
char16_t ideographOf(char16_t character) {
  const std::size_t radical = static_cast<std::size_t>(character) - kFirstRadical;
  if (character >= kFirstRadical && radical < kLikeRadical.size() && kLikeRadical[radical] != u'\u3000') {
    return kLikeRadical[radical];
  }
  const bool kangxi = character >= 0x2F00 && character <= 0x2FD5;
  return kangxi ? QString(QChar(character)).normalized(QString::NormalizationForm_KC).front().unicode()
                : character;
}

/// Fonts draw many radicals and characters with one glyph, and Qt names the first of the two, the radical:
/// nobody who searches or copies would find the character. `map`: what glyphs mean, as lists [<2F45> <0041>
/// ...].
std::string withoutRadicals(std::string map) {
  for (std::size_t at = map.find('['); at != std::string::npos && at + 5 < map.size(); ++at) {
    if (map[at] == ']') {
      at = map.find('[', at);
      if (at == std::string::npos) {
        break;
      }
    } else if (map[at] == '<' && map[at + 5] == '>') {
      const auto meant = static_cast<char16_t>(std::stoul(map.substr(at + 1, 4), nullptr, 16));
      map.replace(at + 1, 4,
                  QString::number(ideographOf(meant), 16).rightJustified(4, QLatin1Char('0')).toStdString());
    }
  }
  return map;
}

void nameIdeographs(QPDF& pdf) {
  for (PdfObject object : pdf.getAllObjects()) {
    if (object.isDictionary() && object.getKey("/ToUnicode").isStream()) {
      PdfObject map = object.getKey("/ToUnicode");
      setContent(map, withoutRadicals(uncompressed(map)));
    }
  }
}

void addTags(QPDF& pdf, const std::vector<PdfPart>& parts) {
  StructureTree tree(pdf);
  std::vector<PdfObject> parents;
  for (PdfObject page : pdf.getAllPages()) {
    FoundParts found;
    PdfObject contents = page.getKey("/Contents");
    setContent(contents, taggedDrawing(uncompressed(contents), parts, found));
    std::vector<PdfObject> elements(found.size());
    for (const auto& [part, number] : found) {
      elements[number] = tree.add(parts[part], number, page);
    }
    page.replaceKey("/StructParents", PdfObject::newInteger(static_cast<long long>(parents.size())));
    parents.push_back(PdfObject::newArray(elements));
  }
  tree.finish(parents);
}

/// Reads a file by QPdfWriter, changes it and writes it. Throws qpdf's exceptions and std::logic_error.
std::string changed(const std::string& pdf, const std::function<void(QPDF&)>& change) {
  QPDF file;
  file.setSuppressWarnings(true);
  file.setAttemptRecovery(false);
  file.processMemoryFile("report", pdf.data(), pdf.size());
  change(file);
  QPDFWriter writer(file);
  writer.setOutputMemory();
  writer.setObjectStreamMode(qpdf_o_disable);  // PDF/A-1 does not allow object streams
  writer.setNewlineBeforeEndstream(true);      // required by PDF/A
  writer.write();
  const std::shared_ptr<Buffer> written = writer.getBufferSharedPointer();
  return {reinterpret_cast<const char*>(written->getBuffer()), written->getSize()};
}

}  // namespace

void markPart(QPainter& painter, std::size_t part) {
  painter.fillRect(QRectF(-static_cast<double>(kMark + part), 0.0, 1.0, 1.0), Qt::black);
}

std::string withStructure(const std::string& pdf, const PdfStructure& structure) {
  try {
    return changed(pdf, [&structure](QPDF& file) {
      addDescription(file, structure);
      addBookmarks(file, structure.bookmarks);
      addTags(file, structure.parts);
      nameIdeographs(file);
    });
  } catch (const std::exception& error) {
    refuse(Text::tr("the pages cannot be given bookmarks: %1", error.what()), Text::tr("report"),
           Text::tr("Write the report again"));
  }
}

std::string searchablePdf(const std::string& pdf) {
  try {
    return changed(pdf, nameIdeographs);
  } catch (const std::exception& error) {
    refuse(Text::tr("the pages cannot be made searchable: %1", error.what()), Text::tr("PDF"),
           Text::tr("Write the file again"));
  }
}

}  // namespace torsio
