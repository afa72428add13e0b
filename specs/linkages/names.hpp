#pragma once
// The names of a linkage file: which points and links exist and where a point sits on a link. For the linkage
// reader only.

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "specs/linkages/linkage_file.hpp"
#include "specs/linkages/reader.hpp"

namespace kempe {

class LinkageNames {
 public:
  LinkageNames(Complaints& complaints, const LinkageFile& file) : complaints_(complaints), file_(file) {}

  /// Complains unless the name is a letter followed by letters, digits and underscores.
  bool check_name(const NameAt& name, const std::string& key);

  /// Registers a point of the ground or a free point; complains if the name is bad or taken.
  bool define_point(const NameAt& name, const std::string& where);
  bool define_link(const NameAt& name);
  void add_link(const std::string& name) { links_.insert(name); }
  void define_joints(const FileLink& link, int line);

  bool is_point(const std::string& name) const { return points_.contains(name); }
  bool is_link(const std::string& name) const { return links_.contains(name); }

  /// Where a point sits in a link's frame ("ground" included), mm; nothing if it is no point of the link.
  std::optional<Point> local_place(const std::string& point, const std::string& link) const;
  /// True if some link, or the ground, holds both.
  bool share_a_link(const std::string& a, const std::string& b) const;

  /// Complain unless defined.
  bool require_point(const NameAt& name, const std::string& key);
  bool require_link(const NameAt& name, const std::string& key);

  /// The value of a key as a defined point or link; complains if absent, no text or not defined.
  std::optional<std::string> point(const LinkageTable& table, std::string_view key);
  std::optional<std::string> link(const LinkageTable& table, std::string_view key);
  /// The value of a key as a place in a link's frame, mm: a point of the link by name, or [x, y] in the file's unit;
  /// complains if it is absent or neither.
  std::optional<Point> place_on(const LinkageTable& table, std::string_view key, const std::string& link);
  /// A list of defined points.
  std::vector<std::string> points(const LinkageTable& table, std::string_view key);

 private:
  Complaints& complaints_;
  const LinkageFile& file_;
  std::map<std::string, std::string> points_;  ///< with where it was defined first
  std::set<std::string> links_;
};

}  // namespace kempe
