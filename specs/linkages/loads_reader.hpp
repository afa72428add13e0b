#pragma once
// The gravity, [[forces]], [[moments]] and [masses] of a linkage file. For the linkage reader only.

#include "specs/linkages/names.hpp"

namespace kempe {

/// Each reads one table and adds what it says to the file's loads, or complains.
void read_force(const LinkageTable& table, LinkageNames& names, LinkageFile& file);
void read_moment(const LinkageTable& table, LinkageNames& names, LinkageFile& file);

/// `name` is the link or the point that has the mass.
void read_mass(const LinkageTable& table, const NameAt& name, LinkageNames& names, LinkageFile& file);

/// Reads gravity, after the masses that it acts on.
void read_gravity(const LinkageTable& root, LinkageFile& file);

}  // namespace kempe
