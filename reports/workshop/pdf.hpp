#pragma once
// Sheets as a PDF file. LibHaru stands in pdf_backend.cpp alone.

#include <memory>
#include <string>

#include "reports/workshop/sheet.hpp"

namespace kempe::workshop {

/// A PDF in the making. Its lettering (osifont, ISO 3098) is embedded: it looks the same everywhere.
class Pdf {
 public:
  Pdf();
  ~Pdf();
  Pdf(const Pdf&) = delete;
  Pdf& operator=(const Pdf&) = delete;

  /// How wide its texts are; valid while this object is.
  Lettering lettering() const;
  void add(const Sheet& sheet);
  /// The file. It depends on the sheets and the title alone: no date, no name of a machine.
  std::string bytes(const std::string& title);

 private:
  class Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace kempe::workshop
