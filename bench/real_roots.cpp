// Real roots of polynomials with double coefficients: intervals of doubles first (real_roots) beside exact arithmetic
// alone (real_roots_exactly). Counters: share of polynomials decided by intervals, mean number of different roots.
//
// Classes: normal coefficients; all roots real (expanded in doubles); a double root planted exactly; two roots 1e-9
// apart.
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <vector>

#include "burmester/geometry/random.hpp"
#include "burmester/geometry/real_roots.hpp"

namespace {

using namespace burmester;
using Coefficients = std::vector<double>;

constexpr int pool_size = 500;

Coefficients times_linear(const Coefficients& p, double root) {
  Coefficients out(p.size() + 1, 0);
  for (std::size_t k = 0; k < p.size(); ++k) out[k] -= root * p[k], out[k + 1] += p[k];
  return out;
}

Coefficients normal(Random& random, int degree) {
  Coefficients out;
  for (int k = 0; k <= degree; ++k) out.push_back(random.normal());
  return out;
}
Coefficients all_real(Random& random, int degree) {
  Coefficients out{1};
  for (int k = 0; k < degree; ++k) out = times_linear(out, random.normal());
  return out;
}
Coefficients double_root(Random& random, int degree) {
  const double root = random.below(64) / 16.0;
  Coefficients out{1};
  for (int k = 2; k < degree; ++k) out = times_linear(out, random.below(64) / 16.0 - 2);
  return times_linear(times_linear(out, root), root);
}
Coefficients close_pair(Random& random, int degree) {
  const double root = random.normal();
  Coefficients out{1};
  for (int k = 2; k < degree; ++k) out = times_linear(out, random.normal());
  return times_linear(times_linear(out, root), root + 1e-9);
}

std::vector<Coefficients> pool(Coefficients (*make)(Random&, int), int degree, const std::string& name) {
  Random random("bench.real_roots." + name);
  std::vector<Coefficients> out;
  for (int i = 0; i < pool_size; ++i) out.push_back(make(random, degree));
  return out;
}

template <class Input, class Solve>
void run(benchmark::State& state, const std::vector<Input>& inputs, Solve solve) {
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(solve(inputs[i]));
    i = (i + 1) % inputs.size();
  }
  double roots = 0, by_intervals = 0, with_roots = 0;
  for (const Input& input : inputs) {
    const std::vector<RealRoot> found = solve(input);
    roots += static_cast<double>(found.size());
    with_roots += !found.empty();
    by_intervals += !found.empty() && found[0].rung() == Rung::intervals;
  }
  state.counters["roots"] = roots / pool_size;
  state.counters["by_intervals"] = with_roots > 0 ? by_intervals / with_roots : 1;
}

const bool registered = [] {
  const struct {
    const char* name;
    Coefficients (*make)(Random&, int);
  } classes[] = {{"normal", normal}, {"all_real", all_real}, {"double_root", double_root}, {"close_pair", close_pair}};
  for (const auto& c : classes)
    for (const int degree : {4, 6, 12}) {
      const std::string name = std::string(c.name) + "/" + std::to_string(degree);
      const std::vector<Coefficients> doubles = pool(c.make, degree, name);
      std::vector<Polynomial<Rational>> rationals;
      for (const Coefficients& p : doubles) rationals.emplace_back(std::vector<Rational>(p.begin(), p.end()));
      benchmark::RegisterBenchmark(("doubles_first/" + name).c_str(), [=](benchmark::State& state) {
        run(state, doubles, [](const Coefficients& p) { return real_roots(p); });
      });
      benchmark::RegisterBenchmark(("exact_alone/" + name).c_str(), [=](benchmark::State& state) {
        run(state, rationals, [](const Polynomial<Rational>& p) { return real_roots_exactly(p); });
      });
    }
  return true;
}();

}  // namespace
