// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/sources/traction_memory.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "samcontact/simulation/cells/motion.hpp"
#include "samcontact/simulation/cells/traction_window.hpp"

namespace samcontact::simulation {
namespace {

using operators::Traction;
using operators::Tractions;

Field& field_of(Tractions& tractions, Traction kind) {
  if (kind == Traction::pressure) return tractions.pressure;
  return kind == Traction::shear_x ? tractions.shear_x : tractions.shear_y;
}

/// Fields of one kind of traction in a memory.
class Part {
 public:
  Part(const TractionMemory& memory, std::size_t terms, int number)
      : cells_(memory.box.surface_size()),
        first_(memory.values.data() + static_cast<std::size_t>(number) * (terms + 1) * cells_) {}
  const double* equivalent() const { return first_; }
  const double* fading(std::size_t term) const { return first_ + (term + 1) * cells_; }

 private:
  std::size_t cells_;
  const double* first_;
};

/// Calls use(kind, part) for all kinds of tractions in a memory.
template <class Use>
void for_kinds(const TractionMemory& memory, std::size_t terms, const Use& use) {
  int number = 0;
  for (const Traction kind : operators::all_tractions) {
    if (memory.has(kind)) use(kind, Part(memory, terms, number++));
  }
}

/// Tractions on the cells of a larger box, as sums over the stored fields; of(part, sum) adds them.
template <class Of>
Tractions over(const Box& whole, const TractionMemory& memory, std::size_t terms, const Of& of) {
  Tractions tractions;
  Field sum;
  for_kinds(memory, terms, [&](Traction kind, const Part& part) {
    sum.assign(memory.box.surface_size(), 0.0);
    of(part, sum);
    Field& field = field_of(tractions, kind);
    field.assign(whole.surface_size(), 0.0);
    insert(sum.data(), memory.box, field.data(), whole);
  });
  return tractions;
}

/// A cell outside the grid is forgotten if its values are smaller than this part of the largest.
constexpr double forgotten = 1e-12;

/// Cells over which the displacement due to tractions in a box is computed: the grid, and the track
/// outside it in few different lengths, so that operators are seldom built.
Box track_box(const Box& loaded, const Grid& grid) {
  const Box surface = Box::surface(grid);
  if (loaded.empty() || surface.contains(loaded)) return surface;
  const auto rounded = [&](int cells) {
    if (cells <= 0) return 0;
    const unsigned unit = std::max(8, grid.nx / 4);
    return static_cast<int>(unit * std::bit_ceil((static_cast<unsigned>(cells) + unit - 1) / unit));
  };
  const int before = rounded(-loaded.i0);
  const int after = rounded(loaded.i0 + loaded.nx - grid.nx);
  return {-before, 0, before + grid.nx + after, grid.ny, 1};
}

/// Cells over which the work of tractions in a box is computed: few different sizes, so that their
/// operators are seldom built; the whole grid if it is periodic.
Box work_box(const Box& loaded, const Grid& grid) {
  if (grid.period.is_on()) return track_box(loaded, grid);
  if (!Box::surface(grid).contains(loaded)) return track_box(loaded, grid);
  const auto rounded = [](int cells, int all) {
    const int unit = std::max(8, (all + 7) / 8);
    return std::min(all, (cells + unit - 1) / unit * unit);
  };
  Box box = loaded;
  box.nx = rounded(loaded.nx, grid.nx);
  box.ny = rounded(loaded.ny, grid.ny);
  box.i0 = std::min(loaded.i0, grid.nx - box.nx);
  box.j0 = std::min(loaded.j0, grid.ny - box.ny);
  return box;
}

/// Work of tractions on the displacement due to tractions [J], both on the cells of a work_box().
double work(const RelaxingBody& body, const Box& box, const Tractions& force,
            const Tractions& cause) {
  return body.cache.displacement(body.body, box.nx, box.ny)
      ->work(force, cause, operators::shear_sign(body.body));
}

void add(double factor, const double* part, Field& sum) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += factor * part[i];
}

/// Sum of shares times means.
double mean_modulus(const Relaxation& relaxation, const RelaxationStep& step) {
  double sum = 0.0;
  for (std::size_t i = 0; i < relaxation.terms(); ++i) sum += relaxation.shares[i] * step.mean[i];
  return sum;
}

/// A memory with additional cells and kinds, whose values there are 0.
TractionMemory extended(const TractionMemory* before, std::size_t terms, const Box& box,
                        int kinds) {
  TractionMemory wider{box, kinds};
  const std::size_t cells = box.surface_size();
  wider.values.assign(wider.count() * (terms + 1) * cells, 0.0);
  if (before == nullptr) return wider;
  wider.supplied = before->supplied;
  double* to = wider.values.data();
  int number = 0;
  for (const Traction kind : operators::all_tractions) {
    if (!wider.has(kind)) continue;
    if (before->has(kind)) {
      const Part part(*before, terms, number++);
      for (std::size_t m = 0; m <= terms; ++m) {
        insert(part.equivalent() + m * before->box.surface_size(), before->box, to + m * cells,
               box);
      }
    }
    to += (terms + 1) * cells;
  }
  return wider;
}

/// Columns at the ends of a box [field][i][j] whose values have faded, outside the grid.
std::array<int, 2> faded_columns(const TractionMemory& memory, const Grid& grid) {
  const Box& box = memory.box;
  const std::size_t cells = box.surface_size(), fields = memory.values.size() / cells;
  Field largest(box.nx, 0.0);  // of each column
  for (std::size_t field = 0; field < fields; ++field) {
    for (std::size_t n = 0; n < cells; ++n) {
      double& most = largest[n / box.ny];
      most = std::max(most, std::fabs(memory.values[field * cells + n]));
    }
  }
  const double limit = forgotten * *std::max_element(largest.begin(), largest.end());
  std::array<int, 2> faded{};
  while (box.i0 + faded[0] < 0 && faded[0] < box.nx && largest[faded[0]] <= limit) ++faded[0];
  const int beyond = std::min(box.i0 + box.nx - grid.nx, box.nx - faded[0]);
  while (faded[1] < beyond && largest[box.nx - 1 - faded[1]] <= limit) ++faded[1];
  return faded;
}

/// Memory without the cells outside the grid that have recovered.
TractionMemory without_faded(TractionMemory memory, const Grid& grid) {
  if (memory.box.empty() || Box::surface(grid).contains(memory.box)) return memory;
  const auto [first, last] = faded_columns(memory, grid);
  if (first + last == 0) return memory;
  const Box from = memory.box;
  memory.box.i0 += first;
  memory.box.nx -= first + last;
  if (memory.box.nx == 0) return {Box{0, 0, 0, 0, 1}, 0, {}, memory.supplied};
  const std::size_t cells = from.surface_size(), fields = memory.values.size() / cells;
  Field kept(fields * memory.box.surface_size());
  for (std::size_t field = 0; field < fields; ++field) {
    extract(memory.values.data() + field * cells, from,
            kept.data() + field * memory.box.surface_size(), memory.box);
  }
  memory.values = std::move(kept);
  return memory;
}

/// Change of the equivalent tractions in a step and mean of the tractions, of one kind [i][j] of
/// the box.
struct Change {
  Field equivalent, mean;
};

/// Advances the fields of one kind, [term][cell], to the end of a step with tractions of the box.
Change advance(double* values, std::size_t cells, const Relaxation& relaxation,
               const RelaxationStep& step, const Field& tractions) {
  const double rest = relaxation.long_time_share(), sum = mean_modulus(relaxation, step);
  Change change{Field(cells), Field(cells)};
  Field past(cells, 0.0);
  for (std::size_t n = 0; n < cells; ++n) past[n] = -sum * values[n];
  for (std::size_t i = 0; i < relaxation.terms(); ++i) {
    add(relaxation.shares[i] * step.decay[i], values + (i + 1) * cells, past);
  }
  for (std::size_t n = 0; n < cells; ++n) {
    const double end = step.compliance * (tractions[n] - past[n]);
    change.equivalent[n] = end - values[n];
    change.mean[n] = rest * (values[n] + 0.5 * change.equivalent[n]);
    values[n] = end;
  }
  for (std::size_t i = 0; i < relaxation.terms(); ++i) {
    double* fading = values + (i + 1) * cells;
    const double share = relaxation.shares[i];
    for (std::size_t n = 0; n < cells; ++n) {
      const double rise = change.equivalent[n];
      change.mean[n] += share * (step.mean[i] * fading[n] + step.lag[i] * rise);
      fading[n] = step.decay[i] * fading[n] + step.mean[i] * rise;
    }
  }
  return change;
}

}  // namespace

RelaxationStep::RelaxationStep(const Relaxation& relaxation, double duration) {
  double modulus = relaxation.long_time_share();
  for (std::size_t i = 0; i < relaxation.terms(); ++i) {
    const double x = duration / relaxation.times[i];
    decay.push_back(std::exp(-x));
    mean.push_back(x > 0 ? -std::expm1(-x) / x : 1.0);
    // A series where the difference would cancel.
    lag.push_back(x < 1e-3 ? 0.5 - x * (1.0 / 6 - x / 24) : (1.0 - mean.back()) / x);
    modulus += relaxation.shares[i] * mean.back();
  }
  if (!(modulus > 0)) {
    throw std::invalid_argument(
        "a body whose shares of relaxation sum to 1 flows without limit: it has no long-time "
        "state");
  }
  compliance = duration == 0 ? 1.0 : 1.0 / modulus;
}

int TractionMemory::count() const { return std::popcount(static_cast<unsigned>(kinds)); }

RelaxingBody::RelaxingBody(const Setup& setup, int body_)
    : cache(setup.cache),
      grid(setup.grid),
      relaxation(setup.bodies[body_].relaxation()),
      body(body_) {}

Tractions TrackTractions::of_box(const Box& other) const {
  if (box == other) return tractions;
  Tractions out;
  for (const Traction kind : operators::all_tractions) {
    const Field& field = tractions.of(kind);
    if (field.empty()) continue;
    Field& part = field_of(out, kind);
    part.assign(other.surface_size(), 0.0);
    copy_common(field.data(), box, part.data(), other);
  }
  return out;
}

void TrackTractions::subtract(const Tractions& other) {
  for (const Traction kind : operators::all_tractions) {
    const Field& field = other.of(kind);
    Field& sum = field_of(tractions, kind);
    if (field.empty()) continue;
    sum.resize(field.size(), 0.0);
    simulation::add(-1.0, field.data(), sum);
  }
}

void TrackTractions::add(double factor, const Tractions& of_grid, const Grid& grid, bool all) {
  const Box surface = Box::surface(grid);
  Field placed;
  for (const Traction kind : operators::all_tractions) {
    const Field& field = of_grid.of(kind);
    Field& sum = field_of(tractions, kind);
    if (field.empty() || (sum.empty() && !all)) continue;
    placed.assign(box.surface_size(), 0.0);
    insert(field.data(), surface, placed.data(), box);
    sum.resize(placed.size(), 0.0);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += factor * placed[i];
  }
}

Field displacement(const TrackTractions& cause, const RelaxingBody& body,
                   std::span<const operators::Axis> axes) {
  const auto of_box = body.cache.displacement(body.body, cause.box.nx, cause.box.ny);
  Field u = (*of_box)(cause.tractions, operators::shear_sign(body.body), axes);
  const Box surface = Box::surface(body.grid);
  if (cause.box == surface) return u;
  const std::size_t wide = cause.box.surface_size(), cells = surface.surface_size();
  Field out(axes.size() * cells);
  for (std::size_t n = 0; n < axes.size(); ++n) {
    extract(u.data() + n * wide, cause.box, out.data() + n * cells, surface);
  }
  return out;
}

TrackTractions equivalent(const TractionMemory& memory, const RelaxingBody& body) {
  const Box whole = track_box(memory.box, body.grid);
  return {whole, over(whole, memory, body.relaxation.terms(),
                      [](const Part& part, Field& sum) { add(1.0, part.equivalent(), sum); })};
}

TrackTractions remembered(const TractionMemory& memory, const RelaxingBody& body,
                          const RelaxationStep& step) {
  const Relaxation& relaxation = body.relaxation;
  const double sum_of_means = mean_modulus(relaxation, step);
  const Box whole = track_box(memory.box, body.grid);
  Tractions sums = over(whole, memory, relaxation.terms(), [&](const Part& part, Field& sum) {
    add(step.compliance * sum_of_means, part.equivalent(), sum);
    for (std::size_t i = 0; i < relaxation.terms(); ++i) {
      add(-step.compliance * relaxation.shares[i] * step.decay[i], part.fading(i), sum);
    }
  });
  return {whole, std::move(sums)};
}

std::shared_ptr<const TractionMemory> moved(std::shared_ptr<const TractionMemory> memory,
                                            const Grid& grid, int cells) {
  if (!memory || cells == 0 || memory->box.empty()) return memory;
  if (grid.period.x == 0) {
    TractionMemory along = *memory;
    along.box = along.box.moved(cells, 0);
    return std::make_shared<const TractionMemory>(std::move(along));
  }
  const Box& from = memory->box;
  TractionMemory around{{0, from.j0, grid.nx, from.ny, 1}, memory->kinds, {}, memory->supplied};
  Grid strip = grid;
  strip.ny = from.ny;
  const std::size_t fields = memory->values.size() / from.surface_size();
  around.values.reserve(fields * around.box.surface_size());
  for (std::size_t field = 0; field < fields; ++field) {
    Field own(around.box.surface_size(), 0.0);
    insert(memory->values.data() + field * from.surface_size(), from, own.data(), around.box);
    own = moved(own, strip, {cells, 0});
    around.values.insert(around.values.end(), own.begin(), own.end());
  }
  return std::make_shared<const TractionMemory>(std::move(around));
}

std::shared_ptr<const TractionMemory> after_step(const TractionMemory* before,
                                                 const RelaxingBody& body,
                                                 const RelaxationStep& step,
                                                 const Tractions& tractions) {
  const Grid& grid = body.grid;
  Box box = window_of(tractions, grid).united(before != nullptr ? before->box : Box{});
  box.nz = 1;
  int kinds = before != nullptr ? before->kinds : 0;
  for (const Traction kind : operators::all_tractions) {
    if (!tractions.of(kind).empty()) kinds |= 1 << static_cast<int>(kind);
  }
  const Relaxation& relaxation = body.relaxation;
  TractionMemory memory = extended(before, relaxation.terms(), box, kinds);
  const std::size_t cells = box.surface_size();
  if (cells == 0) return std::make_shared<const TractionMemory>(std::move(memory));
  const Box around = work_box(box, grid);
  Tractions change, mean;
  double* values = memory.values.data();
  Field own(cells);
  for (const Traction kind : operators::all_tractions) {
    if (!memory.has(kind)) continue;
    const Field& field = tractions.of(kind);
    own.assign(cells, 0.0);
    if (!field.empty()) copy_common(field.data(), Box::surface(grid), own.data(), box);
    const Change here = advance(values, cells, relaxation, step, own);
    values += (relaxation.terms() + 1) * cells;
    for (auto [part, of] : {std::pair{&here.equivalent, &change}, std::pair{&here.mean, &mean}}) {
      Field& whole = field_of(*of, kind);
      whole.assign(around.surface_size(), 0.0);
      insert(part->data(), box, whole.data(), around);
    }
  }
  memory.supplied += work(body, around, mean, change);
  return std::make_shared<const TractionMemory>(without_faded(std::move(memory), grid));
}

double stored_energy(const TractionMemory& memory, const RelaxingBody& body) {
  if (memory.box.empty()) return 0.0;
  const Relaxation& relaxation = body.relaxation;
  const Box box = work_box(memory.box, body.grid);
  const auto energy = [&](double share, const auto& field_of) {
    const auto part = [&](const Part& of, Field& sum) { add(1.0, field_of(of), sum); };
    const Tractions tractions = over(box, memory, relaxation.terms(), part);
    return 0.5 * share * work(body, box, tractions, tractions);
  };
  double sum = energy(relaxation.long_time_share(), [](const Part& of) { return of.equivalent(); });
  for (std::size_t i = 0; i < relaxation.terms(); ++i) {
    sum += energy(relaxation.shares[i], [i](const Part& of) { return of.fading(i); });
  }
  return sum;
}

}  // namespace samcontact::simulation
