// Random tasks, designed on all cores: how large a plagiograph each needs.
//
// usage: many_specs [COUNT]      a thousand unless given

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <iostream>
#include <kempe/kempe.hpp>
#include <optional>
#include <random>
#include <thread>
#include <vector>

namespace {

/// The same number, the same task.
kempe::Spec task(std::size_t number) {
  std::mt19937_64 random(number);
  const auto between = [&random](double lower, double upper) {
    return lower + (upper - lower) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  kempe::Spec spec;
  const double scale = between(0.4, 2.5);
  const double rotation = between(30 * kempe::degree, 150 * kempe::degree);
  spec.copy = kempe::Copy::of(scale, rotation);
  const double away = between(60, 120), width = between(5, 25);
  spec.region = kempe::Region::rectangle({away, -width / 2}, {width, width});
  return spec;
}

/// The sizes of the designs, mm; nothing where there is none.
std::vector<std::optional<double>> sizes_of(std::size_t count) {
  std::vector<std::optional<double>> sizes(count);
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    kempe::Options options;
    options.diagnose = false;
    options.largest_sheets = false;
    for (std::size_t i = next++; i < count; i = next++)
      if (const kempe::Outcome outcome = kempe::design(task(i), options)) sizes[i] = outcome->size();
  };
  std::vector<std::thread> workers(std::max(1U, std::thread::hardware_concurrency()));
  for (std::thread& worker : workers) worker = std::thread(work);
  for (std::thread& worker : workers) worker.join();
  return sizes;
}

}  // namespace

int main(int count, char** arguments) {
  const std::size_t tasks = count > 1 ? std::strtoul(arguments[1], nullptr, 10) : 1000;
  std::vector<double> found;
  for (const auto& size : sizes_of(tasks))
    if (size) found.push_back(*size);
  std::sort(found.begin(), found.end());
  std::cout << found.size() << " designs for " << tasks << " tasks";
  if (!found.empty()) std::cout << "; the median size is " << found[found.size() / 2] << " mm";
  std::cout << '\n';
}
