// Compiled for the processor that builds it, as the loop under these roofs is.
#include "bench/roofs.h"

#include <algorithm>
#include <chrono>

#include "engine/real.h"
#include "engine/simd/lanes.h"

namespace joints::bench {

namespace {

constexpr int tries = 2000;

// The least time of many tries [ns].
template <class F>
double least_ns(const F& work) {
  double least = 1e30;
  for (int n = 0; n < tries; ++n) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const auto end = std::chrono::steady_clock::now();
    least = std::min(least, std::chrono::duration<double, std::nano>(end - start).count());
  }
  return least;
}

// The compiler must have this number in a register and may assume nothing about it.
template <class Number>
void keep(Number& number) {
  asm volatile("" : "+x"(number));
}

// Twelve numbers, each multiplied and added to, over and over: enough to hide the latency.
template <class Number>
double arithmetic(int lanes) {
  constexpr int count = 12, rounds = 1000;
  const double ns = least_ns([] {
    const Number factor = Number{} + real(0.5), term = Number{} + real(1);
    const auto next = [&](auto&... number) {
      ((number = number * factor + term, keep(number)), ...);
    };
    Number a{}, b{}, c{}, d{}, e{}, f{}, g{}, i{}, j{}, k{}, l{}, m{};
    for (int round = 0; round < rounds; ++round) next(a, b, c, d, e, f, g, i, j, k, l, m);
  });
  return 2.0 * count * rounds * lanes / ns;
}

double cache() {
  constexpr std::size_t places = 2 * 8 * 99;  // two groups of eight, 99 joints long
  constexpr std::size_t bytes = places * 44 * sizeof(real), sums = 8;
  constexpr std::size_t loads = bytes / sizeof(Lanes::Vector) / sums * sums;
  std::vector<Lanes> read(loads);
  const double ns = least_ns([&] {
    Lanes::Vector sum[sums] = {};
    for (std::size_t k = 0; k < loads; k += sums)
#pragma GCC unroll 8
      for (std::size_t i = 0; i < sums; ++i) sum[i] = sum[i] + read[k + i].all;
    for (Lanes::Vector& one : sum) keep(one);
  });
  return double(loads * sizeof(Lanes::Vector)) / ns;
}

}  // namespace

std::vector<Roof> roofs() {
  return {{"arithmetic", 1, arithmetic<real>(1)},
          {"arithmetic", lane_count, arithmetic<Lanes::Vector>(lane_count)},
          {"cache", lane_count, cache()}};
}

}  // namespace joints::bench
