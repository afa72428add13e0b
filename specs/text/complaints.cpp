#include "specs/text/complaints.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace kempe {
namespace {

int rank(const InputError& complaint, const std::string& file) {
  if (complaint.file != file) return std::numeric_limits<int>::max();
  return complaint.line > 0 ? complaint.line : std::numeric_limits<int>::max() - 1;
}

}  // namespace

void Complaints::add(int line, std::string key, std::string found, std::string allowed) {
  add(InputError{file_, line, as_in_file_ ? as_in_file_(key) : std::move(key), std::move(found),
                 std::move(allowed)});
}

/// A place between those that stand there, so that of too many the topmost stay.
void Complaints::add(InputError complaint) {
  const auto later = [this](const InputError& a, const InputError& b) {
    return rank(a, file_) < rank(b, file_);
  };
  made_.insert(std::upper_bound(made_.begin(), made_.end(), complaint, later), std::move(complaint));
  if (made_.size() > most) made_.pop_back();
}

bool Complaints::none_about(std::string_view table) const {
  return std::none_of(made_.begin(), made_.end(), [&](const InputError& complaint) {
    const std::string_view key = complaint.key;
    return key.starts_with(table) && (key.size() == table.size() || key[table.size()] == '.');
  });
}

InputError Complaints::all() const {
  InputError first = made_.front();
  first.others.assign(made_.begin() + 1, made_.end());
  return first;
}

}  // namespace kempe
