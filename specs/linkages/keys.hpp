#pragma once
// Every key of a linkage file with a line of meaning: what the reader knows, docs/linkage-file.md explains
// and the schema allows.

#include <span>
#include <string_view>
#include <vector>

namespace kempe {

struct LinkageKey {
  std::string_view table;    ///< "" for the top level; "links.*" for each link
  std::string_view name;     ///< "*" where names are the user's own
  std::string_view allowed;  ///< what may stand there, for error messages
};

std::span<const LinkageKey> linkage_keys();

/// The rule of a key, or null if the table has no such key. A table with the key "*" takes any name.
const LinkageKey* find_linkage_key(std::string_view table, std::string_view name);

/// Names of a table's keys.
std::vector<std::string_view> linkage_key_names(std::string_view table);

}  // namespace kempe
