// Stands for workshop_pdf.cpp where the library that writes PDF files is not compiled: in the browser.
#include "reports/workshop/workshop_pdf.hpp"

namespace kempe {

std::optional<std::string> why_no_workshop_pdf() {
  return "no workshop.pdf: the dimensioned drawings come from the program, kempe synthesize, with the same "
         "spec.";
}

std::string workshop_pdf(const Design&, const WorkshopJob&) { return ""; }

}  // namespace kempe
