// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/normal/survey.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/base/multiversion.hpp"
#include "samcontact/base/reduce.hpp"
#include "samcontact/contact/laws/contact_law.hpp"

namespace samcontact::contact {
namespace {

void add(const Totals& part, Totals& all) {
  all.contacts += part.contacts;
  all.rest_in_contact += part.rest_in_contact;
  all.pressure += part.pressure;
  all.energy += part.energy;
  all.largest_pressure = std::max(all.largest_pressure, part.largest_pressure);
  all.largest_displacement = std::max(all.largest_displacement, part.largest_displacement);
}

/// For at most one block of cells.
SAMCONTACT_MULTIVERSION
void block_totals(const double* p, const double* rest, const double* gap, std::size_t n,
                  Totals& block) {
  double contacts[reduce_lanes] = {}, rests[reduce_lanes] = {}, pressure[reduce_lanes] = {},
         energy[reduce_lanes] = {}, p_max[reduce_lanes] = {}, u_max[reduce_lanes] = {};
  for (std::size_t first = 0; first < n; first += reduce_lanes) {
    const std::size_t width = std::min(reduce_lanes, n - first);
    const auto add_lane = [&](std::size_t l) {
      const double pi = p[first + l], ri = rest[first + l], gi = gap[first + l];
      const double u = std::fabs(ri - gi);
      contacts[l] += in_contact(pi) ? 1.0 : 0.0;
      rests[l] += in_contact(pi) ? ri : 0.0;
      pressure[l] += pi;
      energy[l] += pi * (0.5 * (ri + gi));
      p_max[l] = pi > p_max[l] ? pi : p_max[l];
      u_max[l] = u > u_max[l] ? u : u_max[l];
    };
    if (width == reduce_lanes) {
      for (std::size_t l = 0; l < reduce_lanes; ++l) add_lane(l);
    } else {
      for (std::size_t l = 0; l < width; ++l) add_lane(l);
    }
  }
  for (std::size_t l = 0; l < reduce_lanes; ++l) {
    add({contacts[l], rests[l], pressure[l], energy[l], p_max[l], u_max[l]}, block);
  }
}

struct Criteria {
  double approach, hold, over_p, over_u;
};

struct Summary {
  double error = 0.0, lowest = 0.0;
  std::size_t working = 0, dropped = 0, penetrating = 0;
};

SAMCONTACT_MULTIVERSION
void classify_cells(const double* p, const double* rest, std::size_t n, const Criteria& criteria,
                    unsigned char* states, Summary& summary) {
  double error[reduce_lanes] = {}, lowest[reduce_lanes] = {};
  for (std::size_t first = 0; first < n; first += reduce_lanes) {
    const std::size_t width = std::min(reduce_lanes, n - first);
    const auto evaluate_lane = [&](std::size_t l) {
      const double pi = p[first + l], g = rest[first + l] - criteria.approach;
      const double share = pi * criteria.over_p, opening = g * criteria.over_u;
      const double wrong = std::fabs(share < opening ? share : opening);
      error[l] = wrong > error[l] ? wrong : error[l];
      lowest[l] = g < lowest[l] ? g : lowest[l];
    };
    if (width == reduce_lanes) {
      for (std::size_t l = 0; l < reduce_lanes; ++l) evaluate_lane(l);
    } else {
      for (std::size_t l = 0; l < width; ++l) evaluate_lane(l);
    }
  }
  std::size_t held = 0, pressed = 0, open = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double g = rest[i] - criteria.approach;
    const bool presses = in_contact(p[i]), works = presses && p[i] > criteria.hold * g;
    const bool penetrates = !presses && g < 0;
    states[i] = static_cast<unsigned char>(works + 2 * penetrates);
    held += works;
    pressed += presses;
    open += penetrates;
  }
  summary.working += held;
  summary.dropped += pressed - held;
  summary.penetrating += open;
  summary.error = std::max(summary.error, *std::max_element(error, error + reduce_lanes));
  summary.lowest = std::min(summary.lowest, *std::min_element(lowest, lowest + reduce_lanes));
}

/// Calls part(begin, end, result) for fixed chunks of n cells; returns the results in order.
template <class Result, class Part>
std::vector<Result> by_chunks(std::size_t n, const Part& part) {
  const std::ptrdiff_t chunks = (n + reduce_chunk - 1) / reduce_chunk;
  std::vector<Result> results(chunks);
#pragma omp parallel for schedule(static) if (chunks > 1)
  for (std::ptrdiff_t c = 0; c < chunks; ++c) {
    part(c * reduce_chunk, std::min(n, (c + 1) * reduce_chunk), results[c]);
  }
  return results;
}

}  // namespace

Totals totals(const Field& pressure, const Field& rest, const Field& gap) {
  const auto parts =
      by_chunks<Totals>(pressure.size(), [&](std::size_t begin, std::size_t end, Totals& chunk) {
        for (std::size_t first = begin; first < end; first += reduce_block) {
          Totals block;
          block_totals(&pressure[first], &rest[first], &gap[first],
                       std::min(reduce_block, end - first), block);
          add(block, chunk);
        }
      });
  Totals all;
  for (const Totals& part : parts) add(part, all);
  return all;
}

Survey survey(const Field& pressure, const Field& rest, double approach, double hold,
              const Totals& scales, std::vector<unsigned char>& states) {
  const bool pressed = scales.largest_pressure > 0 && scales.largest_displacement > 0;
  const Criteria criteria{approach, hold, pressed ? 1.0 / scales.largest_pressure : 0.0,
                          pressed ? 1.0 / scales.largest_displacement : 0.0};
  const auto parts = by_chunks<Summary>(pressure.size(), [&](std::size_t begin, std::size_t end,
                                                             Summary& chunk) {
    classify_cells(&pressure[begin], &rest[begin], end - begin, criteria, &states[begin], chunk);
  });
  Survey survey;
  double lowest = 0.0;
  for (const Summary& part : parts) {
    survey.error = std::max(survey.error, part.error);
    lowest = std::min(lowest, part.lowest);
    survey.working += part.working;
    survey.dropped += part.dropped;
    survey.penetrating += part.penetrating;
  }
  // Without pressure, any interpenetration counts in full.
  if (!pressed) survey.error = lowest < 0 ? 1.0 : 0.0;
  return survey;
}

}  // namespace samcontact::contact
