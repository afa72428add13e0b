// Time per pose of the same linkages with Kempe and with SolveSpace's library, and how far their points are apart.
//
// usage: kempe_forward_bench LINKAGE.toml POSES ROUNDS [TASK.json]
// Prints one JSON object; TASK.json gets the task and Kempe's answer for solvers in other languages.

#include <fmt/format.h>

#include <cstdlib>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>

#include "forward_task.hpp"

namespace {

int run(int argc, char** argv) {
  using namespace kempe::bench;
  const int poses = std::atoi(argv[2]), rounds = std::atoi(argv[3]);
  const ForwardTask task = forward_task(argv[1], poses);
  const ForwardResult kempe = move_with_kempe(task, rounds);
  nlohmann::ordered_json json{{"linkage", task.name},
                              {"poses", poses},
                              {"unknowns", task.model.linkage.unknown_count()},
                              {"kempe_us", kempe.us_per_pose},
                              {"kempe_failures", kempe.failures}};
#ifdef KEMPE_BENCH_SLVS
  const ForwardResult peer = move_with_solvespace(task.points, rounds);
  json["solvespace_us"] = peer.us_per_pose;
  json["solvespace_failures"] = peer.failures;
  json["solvespace_apart_mm"] = largest_distance(kempe, peer);
#endif
  fmt::print("{}\n", json.dump());
  if (argc > 4) std::ofstream(argv[4]) << as_json(task.points, kempe);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    fmt::print(stderr, "usage: {} LINKAGE.toml POSES ROUNDS [TASK.json]\n", argv[0]);
    return 2;
  }
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
