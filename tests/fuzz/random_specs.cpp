// Random specs, each searched, mapped and verified independently: how many designs, and not one that does not hold.
// usage: kempe_random_specs COUNT [FIRST] [THREADS]
// Spec number n is the same in every run; a failure aborts and names it.

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "tests/fuzz/structured.hpp"

namespace {

std::string bytes_of(unsigned long number) {
  std::mt19937_64 random(number);
  std::string bytes(200, '\0');
  for (char& byte : bytes) byte = static_cast<char>(random() >> 56);
  return bytes;
}

unsigned long argument(int argc, char** argv, int index, unsigned long otherwise) {
  return argc > index ? std::strtoul(argv[index], nullptr, 10) : otherwise;
}

}  // namespace

int main(int argc, char** argv) {
  const unsigned long count = argument(argc, argv, 1, 100), first = argument(argc, argv, 2, 0);
  const unsigned long threads = argument(argc, argv, 3, 1);
  const auto began = std::chrono::steady_clock::now();
  std::atomic<unsigned long> next{first}, designs{0};
  const auto work = [&] {
    for (unsigned long n = next++; n < first + count; n = next++) {
      const std::string tag = "random spec " + std::to_string(n);
      if (kempe::fuzz::design_from_choices(bytes_of(n), tag) == kempe::fuzz::Outcome::design) ++designs;
    }
  };
  std::vector<std::thread> workers;
  for (unsigned long i = 0; i < threads; ++i) workers.emplace_back(work);
  for (std::thread& worker : workers) worker.join();
  const std::chrono::duration<double> lasted = std::chrono::steady_clock::now() - began;
  std::printf(
      "%lu specs from number %lu: %lu designs, each mapped, verified and read again from its files, 0 "
      "failures; %lu without a design; "
      "%.0f s\n",
      count, first, designs.load(), count - designs.load(), lasted.count());
  return 0;
}
