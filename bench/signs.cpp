// Exact signs of determinants beside the plain double one, and the rungs alone, on the same matrices.
//
// Rows: <route>/<polynomial>/<data>. Routes:
//   plain             in doubles, which proves nothing
//   filtered          exact_sign: the ladder, its first rung inlined
//   intervals         the interval rung alone, which switches the rounding mode per call
//   intervals_batch   the same, switched once per 4096
//   exact             the exact ring of doubles alone
//   rational          Rational in its place
// Data: random (normal entries); near (degenerate but for the rounding of the entries).
// Counters: time per sign; the shares of signs that plain gets wrong, that doubles decide, that intervals decide.
#include <benchmark/benchmark.h>

#include <vector>

#include "burmester/geometry/predicate.hpp"
#include "burmester/geometry/rational.hpp"
#include "near_degenerate.hpp"

namespace {

using namespace burmester;

constexpr int pool_size = 4096;  // larger than the branch predictor's memory

template <class F>
using Arguments = decltype(near_degenerate(F(), std::declval<Random&>()));

template <class F>
std::vector<Arguments<F>> pool(bool near) {
  Random random("bench.signs");
  std::vector<Arguments<F>> out;
  for (int i = 0; i < pool_size; ++i)
    out.push_back(near ? near_degenerate(F(), random)
                       : random_arguments<std::tuple_size_v<Arguments<F>>>(random));
  return out;
}

template <class F>
int plain(const Arguments<F>& x) {
  return *known_sign(F()(x));
}

struct NearestRounding {};

template <class F, class Rounding, class Route>
void time_route(benchmark::State& state, bool near, Route route) {
  const auto arguments = pool<F>(near);
  for (auto _ : state) {
    [[maybe_unused]] const Rounding rounding;
    int sum = 0;
    for (const auto& x : arguments) sum += route(x);
    benchmark::DoNotOptimize(sum);
  }
  state.counters["per_sign"] = benchmark::Counter(
      pool_size, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  int wrong = 0, doubles = 0, intervals = 0;
  for (const auto& x : arguments) {
    const Sign sign = exact_sign<F>(x);
    wrong += plain<F>(x) != sign.sign;
    doubles += sign.decided_by == Rung::doubles;
    intervals += sign.decided_by == Rung::intervals;
  }
  state.counters["plain_wrong"] = 1.0 * wrong / pool_size;
  state.counters["doubles"] = 1.0 * doubles / pool_size;
  state.counters["intervals"] = 1.0 * intervals / pool_size;
}

template <class F, class Rounding = NearestRounding, class Route>
void add(const std::string& name, Route route) {
  for (const bool near : {false, true})
    benchmark::RegisterBenchmark((name + (near ? "/near" : "/random")).c_str(), [=](benchmark::State& state) {
      time_route<F, Rounding>(state, near, route);
    });
}

template <class F>
void add_all(const std::string& name) {
  add<F>("plain/" + name, plain<F>);
  add<F>("filtered/" + name, [](const auto& x) { return exact_sign<F>(x).sign; });
  add<F>("intervals/" + name, [](const auto& x) { return sign_by_intervals<F>(x).value_or(0); });
  add<F, UpwardRounding>("intervals_batch/" + name,
                         [](const auto& x) { return known_sign(evaluate<F, Interval>(x)).value_or(0); });
  add<F>("exact/" + name, [](const auto& x) { return sign_by_exact<F>(x); });
  add<F>("rational/" + name, [](const auto& x) { return *known_sign(evaluate<F, Rational>(x)); });
}

const bool registered = [] {
  add_all<Determinant<3>>("determinant3");
  add_all<Determinant<4>>("determinant4");
  add_all<Orientation2>("orientation2");
  add_all<DyadClosure>("dyad_closure");
  return true;
}();

}  // namespace
