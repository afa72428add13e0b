#include <hpdf.h>
#include <hpdf_doc.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>

#include "geometry/complex_vectors.hpp"
#include "reports/workshop/lettering_font.hpp"
#include "reports/workshop/pdf.hpp"

namespace kempe::workshop {
namespace {

constexpr double points_per_mm = 72 / 25.4;
/// Height of osifont's capitals over the size of its type.
constexpr double capital_share = 0.737;
constexpr int units_per_type = 1000;  // of LibHaru's widths

HPDF_REAL real(double value) { return static_cast<HPDF_REAL>(value); }
HPDF_REAL in_points(double mm) { return real(mm * points_per_mm); }

/// The code points of a text; a byte that is no UTF-8 counts as one of no letter.
std::u32string code_points(std::string_view text) {
  std::u32string points;
  for (std::size_t i = 0; i < text.size();) {
    const auto first = static_cast<unsigned char>(text[i]);
    const int more = first < 0x80   ? 0
                     : first < 0xC2 ? -1
                     : first < 0xE0 ? 1
                     : first < 0xF0 ? 2
                     : first < 0xF5 ? 3
                                    : -1;
    char32_t point = more < 0 ? 0xFFFD : more == 0 ? first : static_cast<char32_t>(first & (0x3F >> more));
    std::size_t used = 1;
    for (int k = 0; k < more; ++k, ++used) {
      if (i + used >= text.size() || (static_cast<unsigned char>(text[i + used]) & 0xC0) != 0x80) {
        point = 0xFFFD;
        break;
      }
      point = (point << 6) | (static_cast<unsigned char>(text[i + used]) & 0x3F);
    }
    points += point < 0x20 || point == 0x7F ? U' ' : point;
    i += used;
  }
  return points;
}

/// The lettering in one code page.
struct Script {
  HPDF_Font font = nullptr;
  std::map<char32_t, char> codes;  ///< those that the font has a letter for
};

/// Code pages in which a text is looked for; LibHaru's UTF-8 would put a table of all characters into every file.
constexpr std::array code_pages{"WinAnsiEncoding", "CP1250", "CP1251", "CP1253", "CP1254", "CP1257"};

struct Stroke {
  double width;                       ///< mm
  std::array<HPDF_UINT16, 6> dashes;  ///< tenths of a mm, 0: none
};

Stroke stroke_of(Pen pen) {
  switch (pen) {
    case Pen::outline: return {0.5, {}};
    case Pen::hidden: return {0.25, {30, 12}};
    case Pen::centre: return {0.25, {60, 8, 6, 8}};
    case Pen::phantom: return {0.25, {60, 8, 6, 8, 6, 8}};
    case Pen::thin: return {0.25, {}};
    case Pen::hatch: return {0.13, {}};
    case Pen::frame: break;
  }
  return {0.7, {}};
}

}  // namespace

class Pdf::Inside {
 public:
  Inside() : file_(HPDF_New(nullptr, nullptr)) {
    if (!file_) throw std::bad_alloc();
    HPDF_SetCompressionMode(file_, HPDF_COMP_ALL);
    load_font();
  }
  ~Inside() { HPDF_Free(file_); }
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;

  double width(std::string_view text, double height) {
    const auto [script, codes] = encoded(text);
    const HPDF_TextWidth wide = HPDF_Font_TextWidth(
        script->font, reinterpret_cast<const HPDF_BYTE*>(codes.data()), static_cast<HPDF_UINT>(codes.size()));
    return wide.width * (height / capital_share) / units_per_type;
  }

  void add(const Sheet& sheet) {
    page_ = HPDF_AddPage(file_);
    pen_.reset();
    HPDF_Page_SetWidth(page_, in_points(sheet.size.x()));
    HPDF_Page_SetHeight(page_, in_points(sheet.size.y()));
    HPDF_Page_SetLineCap(page_, HPDF_ROUND_END);
    HPDF_Page_SetLineJoin(page_, HPDF_ROUND_JOIN);
    for (const SheetMark& mark : sheet.marks) std::visit([this](const auto& one) { put(one); }, mark);
  }

  std::string bytes(const std::string& title) {
    HPDF_SetInfoAttr(file_, HPDF_INFO_TITLE, plain(title).c_str());
    HPDF_SetInfoAttr(file_, HPDF_INFO_CREATOR, "Kempe");
    HPDF_SaveToStream(file_);
    std::string result(HPDF_GetStreamSize(file_), '\0');
    auto size = static_cast<HPDF_UINT32>(result.size());
    HPDF_ReadFromStream(file_, reinterpret_cast<HPDF_BYTE*>(result.data()), &size);
    if (HPDF_GetError(file_) != HPDF_OK || size != result.size())
      throw std::runtime_error("LibHaru could not write the drawings");
    return result;
  }

 private:
  /// LibHaru reads fonts from files only; this is what it does with one, from memory.
  void load_font() {
    const auto font = lettering_font();
    HPDF_Stream stream = HPDF_MemStream_New(file_->mmgr, static_cast<HPDF_UINT>(font.size()));
    HPDF_Stream_Write(stream, font.data(), static_cast<HPDF_UINT>(font.size()));
    definition_ = HPDF_TTFontDef_Load(file_->mmgr, stream, HPDF_TRUE);
    if (!definition_ || HPDF_List_Add(file_->fontdef_list, definition_) != HPDF_OK) throw std::bad_alloc();
    char subset_tag[] = "KEMPEA";
    HPDF_TTFontDef_SetTagName(definition_, subset_tag);
  }

  const Script& script(std::size_t page) {
    if (scripts_[page].font) return scripts_[page];
    Script& one = scripts_[page];
    one.font = HPDF_GetFont(file_, definition_->base_font, code_pages[page]);
    HPDF_Encoder encoder = HPDF_GetEncoder(file_, code_pages[page]);
    for (int code = 0x20; code < 0x100; ++code) {
      const char32_t point = HPDF_Encoder_GetUnicode(encoder, static_cast<HPDF_UINT16>(code));
      if (point == U' ' || HPDF_TTFontDef_GetGlyphid(definition_, static_cast<HPDF_UINT16>(point)) != 0)
        one.codes.emplace(point, static_cast<char>(code));
    }
    return one;
  }

  /// The text in the first code page that has all of its letters, or in the one that has most.
  std::pair<const Script*, std::string> encoded(std::string_view text) {
    const std::u32string points = code_points(text);
    const Script* best = nullptr;
    std::size_t least = 0;
    for (std::size_t page = 0; page < code_pages.size() && (!best || least > 0); ++page) {
      const Script& one = script(page);
      const auto missing = static_cast<std::size_t>(std::count_if(
          points.begin(), points.end(), [&](char32_t point) { return !one.codes.contains(point); }));
      if (best && missing >= least) continue;
      best = &one;
      least = missing;
    }
    std::string codes;
    for (const char32_t point : points) {
      const auto found = best->codes.find(point);
      codes += found == best->codes.end() ? '?' : found->second;
    }
    return {best, codes};
  }

  /// For the file's properties, which readers show in one code page.
  static std::string plain(const std::string& text) {
    std::string result;
    for (const char32_t point : code_points(text)) result += point < 0x7F ? static_cast<char>(point) : '?';
    return result;
  }

  void use(Pen pen) {
    if (pen_ == pen) return;
    pen_ = pen;
    const Stroke stroke = stroke_of(pen);
    HPDF_Page_SetLineWidth(page_, in_points(stroke.width));
    std::array<HPDF_UINT16, 6> dashes{};
    HPDF_UINT count = 0;
    for (const HPDF_UINT16 dash : stroke.dashes)
      if (dash > 0)
        dashes[count++] = static_cast<HPDF_UINT16>(std::max(1.0, std::round(0.1 * dash * points_per_mm)));
    HPDF_Page_SetDash(page_, count == 0 ? nullptr : dashes.data(), count, 0);
  }

  void fill_with(Fill fill) {
    HPDF_Page_SetGrayFill(page_, real(fill == Fill::paper ? 1 : fill == Fill::shade ? 0.9 : 0));
  }

  void go(const Point& at) { HPDF_Page_MoveTo(page_, in_points(at.x()), in_points(at.y())); }

  /// An arc as Bezier curves of at most an eighth of a turn, which depart from it by less than 5e-6 of its radius.
  void edge(const ArcVertex& from, const Point& to) {
    if (from.bulge == 0) {
      HPDF_Page_LineTo(page_, in_points(to.x()), in_points(to.y()));
      return;
    }
    const Complex a = as_complex(from.at), b = as_complex(to);
    const Complex centre = arc_centre(a, b, from.bulge);
    const double sweep = 4 * std::atan(from.bulge);
    const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / (pi / 4))));
    const double step = sweep / pieces, pull = 4.0 / 3 * std::tan(step / 4);
    Complex arm = a - centre;
    for (int i = 1; i <= pieces; ++i) {
      const Complex next = i == pieces ? b - centre : (a - centre) * std::polar(1.0, i * step);
      const Complex first = centre + arm * Complex(1, pull), second = centre + next * Complex(1, -pull);
      HPDF_Page_CurveTo(page_, in_points(first.real()), in_points(first.imag()), in_points(second.real()),
                        in_points(second.imag()), in_points((centre + next).real()),
                        in_points((centre + next).imag()));
      arm = next;
    }
  }

  void put(const SheetPath& path) {
    if (path.ring.size() < 2) return;
    if (path.stroked) use(path.pen);
    if (path.fill != Fill::none) fill_with(path.fill);
    go(path.ring.front().at);
    for (std::size_t i = 0; i + 1 < path.ring.size(); ++i) edge(path.ring[i], path.ring[i + 1].at);
    if (path.closed) {
      edge(path.ring.back(), path.ring.front().at);
      HPDF_Page_ClosePath(page_);
    }
    if (path.fill == Fill::none)
      HPDF_Page_Stroke(page_);
    else if (path.stroked)
      HPDF_Page_FillStroke(page_);
    else
      HPDF_Page_Fill(page_);
  }

  void put(const SheetText& text) {
    const auto [script, codes] = encoded(text.text);
    const double share = text.align == Align::left ? 0 : text.align == Align::middle ? 0.5 : 1;
    const Complex along = std::polar(1.0, text.turn);
    const Point start = text.at - share * (share > 0 ? width(text.text, text.height) : 0.0) * as_point(along);
    fill_with(Fill::ink);
    HPDF_Page_BeginText(page_);
    HPDF_Page_SetFontAndSize(page_, script->font, in_points(text.height / capital_share));
    HPDF_Page_SetTextMatrix(page_, real(along.real()), real(along.imag()), real(-along.imag()),
                            real(along.real()), in_points(start.x()), in_points(start.y()));
    HPDF_Page_ShowText(page_, codes.c_str());
    HPDF_Page_EndText(page_);
  }

  void put(const ClipBegin& clip) {
    HPDF_Page_GSave(page_);
    const Point size = clip.box.upper - clip.box.lower;
    HPDF_Page_Rectangle(page_, in_points(clip.box.lower.x()), in_points(clip.box.lower.y()),
                        in_points(size.x()), in_points(size.y()));
    HPDF_Page_Clip(page_);
    HPDF_Page_EndPath(page_);
    pen_.reset();
  }

  void put(const ClipEnd&) {
    HPDF_Page_GRestore(page_);
    pen_.reset();
  }

  HPDF_Doc file_;
  HPDF_FontDef definition_ = nullptr;
  HPDF_Page page_ = nullptr;
  std::optional<Pen> pen_;
  std::array<Script, code_pages.size()> scripts_;
};

Pdf::Pdf() : inside_(std::make_unique<Inside>()) {}
Pdf::~Pdf() = default;

Lettering Pdf::lettering() const {
  return
      [inside = inside_.get()](std::string_view text, double height) { return inside->width(text, height); };
}

void Pdf::add(const Sheet& sheet) { inside_->add(sheet); }
std::string Pdf::bytes(const std::string& title) { return inside_->bytes(title); }

}  // namespace kempe::workshop
