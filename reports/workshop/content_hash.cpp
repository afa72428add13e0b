#include "reports/workshop/content_hash.hpp"

#include <fmt/format.h>

#include <boost/uuid/detail/sha1.hpp>

namespace kempe::workshop {

std::string content_hash(std::string_view bytes) {
  boost::uuids::detail::sha1 sha1;
  sha1.process_bytes(bytes.data(), bytes.size());
  unsigned int digest[5];
  sha1.get_digest(digest);
  std::string text;
  for (const unsigned int word : digest) text += fmt::format("{:08x}", word);
  return text;
}

}  // namespace kempe::workshop
