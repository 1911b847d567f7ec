// SPDX-License-Identifier: Apache-2.0
#include "sim_harness/design/turbulence_fit.hpp"

#include <cmath>
#include <functional>

#include "core/units.hpp"
#include "sim_harness/analysis/golden_section.hpp"
#include "sim_harness/wind/parameter_check.hpp"

namespace lac::sim {
namespace {

constexpr auto kWhere = "fit of a Kaimal model";
constexpr int kSteps = 60;
constexpr int kNodes = 201;  // of the tensor: coherence to 1e-3 at 30 m

/// Where a function of log x is least, for x between two bounds.
double least(double low, double high, const std::function<double(double)>& misfit) {
  return std::exp(golden_section(std::log(low), std::log(high), kSteps,
                                 [&](double log_x) { return misfit(std::exp(log_x)); }));
}

/// A curve over k1 and how much its points count.
struct Target {
  std::vector<double> k1_radpm;
  std::vector<double> values;
  std::vector<double> weights;

  void add(double k1, double value, double weight) {
    k1_radpm.push_back(k1), values.push_back(value), weights.push_back(weight);
  }
  template <class Model>
  double misfit(const Model& model) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double d = model(k1_radpm[i]) - values[i];
      sum += weights[i] * d * d;
    }
    return sum;
  }
};

/// sigma enters the spectrum as a factor: the best one of a length is known.
KaimalComponent fit_component(const Target& k1_density) {
  const auto shape = [](double length_m, double k1_radpm) {  // f S(f) for sigma 1
    const double f_hz = k1_radpm / (2.0 * kPi);
    return f_hz * KaimalComponent{1.0, length_m}.spectrum(f_hz, 1.0);
  };
  const auto best_variance = [&](double length_m) {
    double product = 0.0, square = 0.0;
    for (std::size_t i = 0; i < k1_density.values.size(); ++i) {
      const double s = shape(length_m, k1_density.k1_radpm[i]);
      product += k1_density.weights[i] * s * k1_density.values[i];
      square += k1_density.weights[i] * s * s;
    }
    return product / square;
  };
  const double length_m = least(1.0, 1e4, [&](double l) {
    const double variance = best_variance(l);
    return k1_density.misfit([&](double k1) { return variance * shape(l, k1); });
  });
  return {std::sqrt(best_variance(length_m)), length_m};
}

/// Squared: exp(-decay distance sqrt((k1/(2 pi))^2 + offset^2)).
struct Exponential {
  double decay = 0.0;
  double offset_per_m = 0.0;

  double at(double distance_m, double k1_radpm) const {
    return std::exp(-decay * distance_m * std::hypot(k1_radpm / (2.0 * kPi), offset_per_m));
  }
};

Exponential fit_exponential(const Target& coherence, double distance_m) {
  const auto misfit = [&](double decay, double offset_per_m) {
    const Exponential e{decay, offset_per_m};
    return coherence.misfit([&](double k1) { return e.at(distance_m, k1); });
  };
  const auto best_decay = [&](double offset_per_m) {
    return least(1e-2, 1e2, [&](double decay) { return misfit(decay, offset_per_m); });
  };
  const double offset = least(1e-6, 1e-1, [&](double o) { return misfit(best_decay(o), o); });
  return {best_decay(offset), offset};
}

}  // namespace

KaimalTurbulence fit_kaimal(const MannParams& mann, const FitSettings& s) {
  require(std::isfinite(mann.evolution_s), kWhere, "evolution [s]", mann.evolution_s, "a time");
  require(s.points >= 3, kWhere, "points", s.points, "3 or more");
  const MannTensor tensor(mann);
  Target u, v, w, across, along;
  const double step = std::log(s.last_k1_radpm / s.first_k1_radpm) / (s.points - 1);
  for (int i = 0; i < s.points; ++i) {
    const double k1 = s.first_k1_radpm * std::exp(i * step);
    const SpectralTensor f = tensor.spectra(k1);
    u.add(k1, 2.0 * k1 * f[kUu], 1.0);
    v.add(k1, 2.0 * k1 * f[kVv], 1.0);
    w.add(k1, 2.0 * k1 * f[kWw], 1.0);
    const auto squared = [&](const Separation& separation) {
      const double root = tensor.cross_spectra(k1, separation, kNodes)[kUu].real() / f[kUu];
      return root * std::abs(root);
    };
    across.add(k1, squared({s.dy_m, s.dz_m, 0.0}), 1.0 / k1);
    along.add(k1, squared({0.0, 0.0, s.dx_m / s.mean_speed_mps}), 1.0 / k1);
  }
  const Exponential yz = fit_exponential(across, std::hypot(s.dy_m, s.dz_m));
  const Exponential x = fit_exponential(along, s.dx_m);
  KaimalTurbulence t;
  t.model = {fit_component(u), fit_component(v), fit_component(w), 0.5 * yz.decay,
             0.12 / yz.offset_per_m};
  t.evolution = {x.decay, x.offset_per_m};
  return t;
}

}  // namespace lac::sim
