#pragma once
// The [[drivers]] of a linkage file. For the linkage reader only.

#include "specs/linkages/names.hpp"

namespace kempe {

/// Reads one driver and adds it to the file's, or complains.
void read_driver(const LinkageTable& table, LinkageNames& names, LinkageFile& file);

}  // namespace kempe
