#include "specs/text/complaints.hpp"

#include <limits>

namespace kempe {
namespace {

int rank(int line) { return line > 0 ? line : std::numeric_limits<int>::max(); }

}  // namespace

void Complaints::add(int line, std::string key, std::string found, std::string allowed) {
  if (first_ && rank(first_->line) <= rank(line)) return;
  first_ = InputError{file_, line, std::move(key), std::move(found), std::move(allowed)};
}

void Complaints::add(InputError about_other_file) {
  if (!first_) first_ = std::move(about_other_file);
}

}  // namespace kempe
