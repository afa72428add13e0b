#pragma once
// By which a drawing names the design it belongs to.

#include <string>
#include <string_view>

namespace kempe::workshop {

/// SHA-1 of the bytes in hexadecimal: what `sha1sum design.json` prints. It tells files apart; it is no protection.
std::string content_hash(std::string_view bytes);

}  // namespace kempe::workshop
