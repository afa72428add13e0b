// kempe_report_specimens FOLDER: writes each specimen's report for the browser tests.
#include <cstdio>
#include <filesystem>

#include "reports/atomic_file.hpp"
#include "tests/reports/report_specimens.hpp"

int main(int count, char** arguments) {
  if (count != 2) {
    std::fputs("usage: kempe_report_specimens FOLDER\n", stderr);
    return 2;
  }
  std::vector<kempe::OutputFile> files;
  for (const auto& specimen : kempe::testing::report_specimens())
    files.push_back({specimen.name + ".html", kempe::html_report(specimen.design, specimen.extras)});
  if (const auto written = kempe::write_whole(arguments[1], files); !written) {
    std::fprintf(stderr, "%s\n", written.error().c_str());
    return 1;
  }
  return 0;
}
