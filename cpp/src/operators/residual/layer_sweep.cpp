// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/residual/layer_sweep.hpp"

#include <algorithm>

#include "samcontact/base/multiversion.hpp"
#include "samcontact/operators/residual/interface_waves.hpp"
#include "samcontact/operators/residual/sweep_lanes.hpp"

namespace samcontact::operators::layers {
namespace {

/// Avoids a division by 0 for the wavenumber 0, which has no amplitude.
constexpr double tiny = 1e-30;

/// Mode that leaves a layer, from the sums over all its cells as received by the next layer.
SAMCONTACT_INLINE Wave left_by(const Mode& mode, const Constants& k, const Sums& r) {
  const Lanes step = r.d - r.c;
  const Lanes w = mode[thickness] * (r.w - step) + mode[leaving_shift] * step;
  const Lanes g = mode[leaving];
  return {{-g * ((1 - k.kappa) * (r.c + r.d) + k.kappa * w), -g * k.kappa * step}, -g * r.o};
}

/// Sums over cells that are equivalent to a mode entering a layer.
SAMCONTACT_INLINE Sums sums_of(const Mode& mode, const Constants& k, const Wave& wave) {
  const Lanes over = 1.0 / (mode[leaving] + tiny);
  Sums r;
  r.c = (0.5 / k.kappa) * wave.plane.f * over;
  r.d = -r.c;
  const Lanes step = -2.0 * r.c, w = (-1 / k.kappa) * wave.plane.p * over;
  r.w = step + (w - mode[leaving_shift] * step) / (mode[thickness] + tiny);
  r.o = -wave.across * over;
  return r;
}

/// One block and the data of its sweep.
template <int parts>
struct Block {
  const SweptStack& stack;
  const Layout& layout;
  const char* used;
  const double* row;
  int step;
  const double* values;
  Rotated* rotated;
  Sums* below;
  LayerWaves* waves;

  SAMCONTACT_INLINE Mode mode(const SweptStack::Layer& layer) const {
    return {row + static_cast<std::ptrdiff_t>(layer.mode) * step, step};
  }

  /// Eigenstress of the cells of a layer, and the mode that leaves it at its top. For the infinite
  /// layer also the integrals over the cells below, as nothing returns from there.
  SAMCONTACT_INLINE void sweep_up(int n) const {
    const auto& layer = stack.layers()[n];
    const Mode at = mode(layer);
    const Constants constants(layer);
    const bool endless = layer.is_endless();
    Lanes v[parts][6];
    Sums sums[parts];
    for (int k = std::min(layer.last, layout.nz) - 1; k >= layer.first; --k) {
      for (int p = 0; p < parts; ++p) {
        if (endless) below[k * parts + p] = sums[p].integrals(at);
        sums[p].recede(at[decay]);
      }
      if (!used[k]) {
        for (int p = 0; p < parts; ++p) rotated[k * parts + p] = Rotated{};
        continue;
      }
      load<parts>(layout, values, k, v);
      for (int p = 0; p < parts; ++p) {
        Rotated& t = rotated[k * parts + p];
        eigenstress(at, constants, v[p], t);
        sums[p].add(t, -1.0);
      }
    }
    for (int p = 0; p < parts; ++p) {
      waves[n * parts + p].up = left_by(at, constants, sums[p]);
      waves[n * parts + p].b = Wave{};
    }
  }

  /// Mode that leaves a layer at its bottom.
  SAMCONTACT_INLINE void sweep_down(int n) const {
    const auto& layer = stack.layers()[n];
    const Mode at = mode(layer);
    Sums sums[parts];
    for (int k = layer.first; k < layer.last; ++k) {
      for (int p = 0; p < parts; ++p) {
        sums[p].recede(at[decay]);
        if (k < layout.nz) sums[p].add(rotated[k * parts + p], 1.0);
      }
    }
    const Constants constants(layer);
    for (int p = 0; p < parts; ++p) {
      waves[n * parts + p].down = left_by(at, constants, sums[p]);
    }
  }

  /// Integrals over the material below each cell of a layer, with the mode from its bottom.
  SAMCONTACT_INLINE void integrate_below(int n) const {
    const auto& layer = stack.layers()[n];
    const Mode at = mode(layer);
    const Constants constants(layer);
    Sums sums[parts];
    for (int p = 0; p < parts; ++p) {
      sums[p] = sums_of(at, constants, waves[n * parts + p].b);
    }
    for (int k = layer.last - 1; k >= layer.first; --k) {
      for (int p = 0; p < parts; ++p) {
        if (k < layout.nz) below[k * parts + p] = sums[p].integrals(at);
        sums[p].recede(at[decay]);
        if (k < layout.nz) sums[p].add(rotated[k * parts + p], -1.0);
      }
    }
  }

  /// Downwards: integrals over the material above, with the mode from the top of the layer, and the
  /// stress.
  SAMCONTACT_INLINE void finish(int n, const Target& target) const {
    const auto& layer = stack.layers()[n];
    const Mode at = mode(layer);
    const Constants constants(layer);
    Lanes v[parts][6];
    Sums above[parts];
    for (int p = 0; p < parts; ++p) {
      above[p] = sums_of(at, constants, waves[n * parts + p].a);
    }
    for (int k = layer.first; k < std::min(layer.last, layout.nz); ++k) {
      for (int p = 0; p < parts; ++p) {
        const Rotated& t = rotated[k * parts + p];
        Sums up = above[p].integrals(at), down = below[k * parts + p];
        up.add_own(at, t, 1.0);
        down.add_own(at, t, -1.0);
        Rotated stress;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled at once
        infinite_space(constants, up, down, t, stress);
        rotate_back(at, stress, layout.deviator, v[p]);
        above[p].recede(at[decay]);
        above[p].add(t, 1.0);
      }
      store<parts>(target, v, k);
    }
  }
};

template <int parts>
SAMCONTACT_INLINE void sweep_block(const Block<parts>& block, Interfaces* interfaces,
                                   const Target& target) {
  const auto& layers = block.stack.layers();
  const int count = static_cast<int>(layers.size());
  fill_interfaces(block.stack, block.row, block.step, interfaces);
  for (int n = count - 1; n >= 0; --n) {
    block.sweep_up(n);
    if (!layers[n].is_endless()) block.sweep_down(n);
  }
  reflect(block.stack, interfaces, parts, block.waves);
  for (int n = 0; n < count; ++n) {
    if (!layers[n].is_endless()) block.integrate_below(n);
    block.finish(n, target);
  }
}

SAMCONTACT_MULTIVERSION
void sweep_complex(const Block<2>& block, Interfaces* interfaces, const Target& target) {
  sweep_block<2>(block, interfaces, target);
}

SAMCONTACT_MULTIVERSION
void sweep_real(const Block<1>& block, Interfaces* interfaces, const Target& target) {
  sweep_block<1>(block, interfaces, target);
}

template <class T>
constexpr std::size_t numbers = sizeof(T) / sizeof(double);

}  // namespace

Scratch::Scratch(const SweptStack& stack, int parts) {
  const auto cells = static_cast<std::size_t>(stack.cells()), layers = stack.layers().size();
  rotated.resize(cells * parts * numbers<Rotated>);
  below.resize(cells * parts * numbers<Sums>);
  interfaces.resize(layers * numbers<Interfaces>);
  waves.resize(layers * parts * numbers<LayerWaves>);
}

void sweep(const SweptStack& stack, int parts, const Layout& layout, const char* used,
           const double* row, int step, const double* values, const Target& target,
           Scratch& scratch) {
  auto* rotated = reinterpret_cast<Rotated*>(scratch.rotated.data());
  auto* below = reinterpret_cast<Sums*>(scratch.below.data());
  auto* interfaces = reinterpret_cast<Interfaces*>(scratch.interfaces.data());
  auto* waves = reinterpret_cast<LayerWaves*>(scratch.waves.data());
  if (parts == 2) {
    sweep_complex({stack, layout, used, row, step, values, rotated, below, waves}, interfaces,
                  target);
  } else {
    sweep_real({stack, layout, used, row, step, values, rotated, below, waves}, interfaces, target);
  }
}

}  // namespace samcontact::operators::layers
