#include "app/batch/index.hpp"

#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "specs/text/printable.hpp"

namespace kempe::app {

/// As it stands in the file. All zero: empty, as a new file is.
struct BatchIndex::Slot {
  std::uint64_t key = 0;
  std::uint64_t place = 0;  ///< 0: none; else 1 + offset, and the journal's number above it
};

namespace {

constexpr int offset_bits = 44;  ///< 16 terabytes, of a million journals
constexpr std::uint64_t offset_mask = (std::uint64_t{1} << offset_bits) - 1;

/// No key is that of an empty slot.
std::uint64_t stored(std::uint64_t key) { return key == 0 ? 1 : key; }

std::string no_table(const std::filesystem::path& folder, int error) {
  return "cannot keep a table in " + printable(folder.string()) + ": " + std::strerror(error);
}

}  // namespace

tl::expected<BatchIndex, std::string> BatchIndex::make(const std::filesystem::path& folder,
                                                       std::int64_t count) {
  std::string pattern = (folder / "kempe-XXXXXX.tmp").string();
  const int file = ::mkstemps(pattern.data(), 4);
  if (file < 0) return tl::unexpected(no_table(folder, errno));
  ::unlink(pattern.c_str());
  BatchIndex index(folder, file,
                   std::bit_ceil(static_cast<std::uint64_t>(2 * std::max<std::int64_t>(count, 1))));
  if (::ftruncate(file, static_cast<off_t>(index.slots_ * sizeof(Slot))) != 0)
    return tl::unexpected(no_table(folder, errno));
  return index;
}

BatchIndex::BatchIndex(BatchIndex&& other) noexcept
    : folder_(std::move(other.folder_)), file_(std::exchange(other.file_, -1)), slots_(other.slots_),
      failure_(std::move(other.failure_)) {}

BatchIndex::~BatchIndex() {
  if (file_ >= 0) ::close(file_);
}

/// The slot that holds a key, or the empty one where it belongs; nothing if the file cannot be read.
std::optional<std::uint64_t> BatchIndex::slot_of(std::uint64_t key, Slot& found) const {
  for (std::uint64_t slot = key & (slots_ - 1);; slot = (slot + 1) & (slots_ - 1)) {
    const ssize_t bytes = ::pread(file_, &found, sizeof found, static_cast<off_t>(slot * sizeof found));
    if (bytes != sizeof found) {
      failure_ = no_table(folder_, bytes < 0 ? errno : EIO);
      return std::nullopt;
    }
    if (found.key == 0 || found.key == key) return slot;
  }
}

void BatchIndex::write(std::uint64_t slot, const Slot& contents) {
  const ssize_t bytes =
      ::pwrite(file_, &contents, sizeof contents, static_cast<off_t>(slot * sizeof contents));
  if (bytes != sizeof contents) failure_ = no_table(folder_, bytes < 0 ? errno : ENOSPC);
}

void BatchIndex::add(std::uint64_t key) {
  Slot found;
  const auto slot = slot_of(stored(key), found);
  if (slot && found.key == 0) write(*slot, {stored(key), 0});
}

void BatchIndex::set(std::uint64_t key, const JournalPlace& place) {
  Slot found;
  const auto slot = slot_of(stored(key), found);
  if (!slot || found.key == 0) return;
  const auto journal = static_cast<std::uint64_t>(place.journal),
             offset = static_cast<std::uint64_t>(place.offset);
  write(*slot, {found.key, (journal << offset_bits) | (1 + offset)});
}

std::optional<JournalPlace> BatchIndex::place(std::uint64_t key) const {
  Slot found;
  if (!slot_of(stored(key), found) || found.place == 0) return std::nullopt;
  return JournalPlace{static_cast<int>(found.place >> offset_bits),
                      static_cast<std::int64_t>((found.place & offset_mask) - 1)};
}

}  // namespace kempe::app
