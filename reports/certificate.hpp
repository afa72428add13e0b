#pragma once
// certificate.jsonl, made for a design or for the proof that there is none.

#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "kinematics/stop_flag.hpp"
#include "synthesis/certificate/proof_tree.hpp"
#include "synthesis/design/design.hpp"

namespace kempe {

inline const std::string certificate_name = "certificate.jsonl";

/// True if the design has a bound of an objective that the log has rules for (size, transmission).
bool has_rules(const Design& design);

struct Certificate {
  std::string log;              ///< the file's text
  std::optional<double> bound;  ///< what it proves; mm or rad
};

using CertificateOrNone = tl::expected<Certificate, certificate::NoLog>;

/// The log that no design is better than the design's bound, of a design that has rules; else why there is none. A bound that
/// touches the best design, or whose proof is long, is made looser by a millionth of itself or more: the design is to state the
/// bound that the log proves.
/// It rests on what spec and search say of the design, not on its map.
CertificateOrNone certificate_of(const Design& design, const StopFlag& stop = {});

/// The log that no design of the spec exists.
tl::expected<std::string, certificate::NoLog> certificate_of_none(const Spec& spec,
                                                                  const StopFlag& stop = {});

/// "certificate.jsonl is left out: ..."
std::string left_out_sentence(certificate::NoLog why);

}  // namespace kempe
