#pragma once
// Files that appear whole or not at all.
//
//  1. A file is written beside its place, under a short name of its own that ends in .tmp, and renamed. On failure nothing
//     is left behind.
//  2. A file that is replaced keeps its mode, and its owner where the system allows it. A link stays a link: what it leads
//     to is replaced.
//  3. What is no regular file is never replaced: devices and pipes are written to (a pipe must have a reader), and folders,
//     sockets and disks are refused. /dev/stdout and other names of an open file are written to as that file.
//  4. Nobody waits for ever: another program that keeps a folder locked is waited for some ten seconds.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace kempe {

/// A file's name and whole contents.
struct OutputFile {
  std::filesystem::path name;  ///< relative to the output folder; may have one sub-folder
  std::string contents;
};

/// Writes one file. The error is a sentence that names the path.
tl::expected<void, std::string> write_whole(const std::filesystem::path& path, std::string_view contents);

/// Files of one folder that appear together: each is written beside its place as it comes, so that their contents need
/// not wait in memory, and all are renamed at the end. What was not put in place is taken away with the object, and so
/// are the folders that were made for it.
class FolderDraft {
 public:
  explicit FolderDraft(std::filesystem::path folder);  ///< made if absent, with the first file
  FolderDraft(FolderDraft&&) noexcept;
  FolderDraft& operator=(FolderDraft&&) = delete;
  ~FolderDraft();

  /// The error is a sentence that names the path.
  tl::expected<void, std::string> add(const OutputFile& file);
  /// Begins a file that comes in pieces; add() is this with one piece, and what it is given is written afterwards.
  tl::expected<void, std::string> begin(const std::filesystem::path& name);
  /// The next piece of a file that was begun. Small pieces are gathered before they are written.
  tl::expected<void, std::string> append(const std::filesystem::path& name, std::string_view piece);
  /// Brings what add() was given to the disk, so that a crash does not take it, and closes those files: till then they are held open.
  tl::expected<void, std::string> synchronise();
  /// Writes what is left of files in pieces, brings all to the disk, then renames all files; a failure before the first rename leaves the folder as it was.
  tl::expected<void, std::string> put_in_place();

  /// The names of the files added, in order.
  std::vector<std::string> names() const;
  /// Where a file that was added lies until it is put in place; nothing if there is none of that name.
  std::optional<std::filesystem::path> draft_of(const std::string& name) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Writes all files into `folder` (made if absent) or none.
tl::expected<void, std::string> write_whole(const std::filesystem::path& folder,
                                            const std::vector<OutputFile>& files);

}  // namespace kempe
