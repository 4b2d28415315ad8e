// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/zones/low_bands.hpp"

#include <algorithm>
#include <utility>

#include "samcontact/base/interrupt.hpp"

namespace samcontact::operators {

/// Zero-initialised numbers of one thread, kept between calls.
double* of_zeros(std::size_t count) {
  static thread_local Field buffer;
  if (buffer.size() < count) buffer.resize(count);
  std::fill_n(buffer.begin(), count, 0.0);
  return buffer.data();
}

/// Nodes of a band, with the spectrum of the strain.
struct LowBands::Lattice {
  NodePlanes planes;
  ZoneTables::Operators operators;
  VolumeSpectrum spectrum;

  Lattice(NodePlanes given, ZoneTables::Operators of, int layers, const ZoneTables& tables)
      : planes(std::move(given)),
        operators(std::move(of)),
        spectrum(operators->transform(), layers, operators->tensor(),
                 tables.borrow(operators->transform().mh() * operators->transform().row_size() *
                               count(operators->tensor()) * layers)) {}

  std::vector<std::vector<fft::RowRun>> rows;  // that zones read, by layer

  const NodeSpread& nodes() const { return planes.nodes(); }
  std::size_t plane_size() const { return planes.plane_size(); }
  int layers() const { return spectrum.nz; }
};

LowBands::LowBands(std::shared_ptr<const ZoneTables> tables, const std::vector<Box>& zones)
    : tables_(std::move(tables)),
      grid_(tables_->grid()),
      zones_(zones),
      tensor_(tables_->tensor()) {
  Box cells = Box::surface(grid_);
  for (const Box& zone : zones_) {
    first_.push_back(cells_);
    cells_ += zone.volume_size();
    layers_ = std::max(layers_, zone.nz);
    cells = cells.united(zone);
  }
  const NodePlanes middle = tables_->middle_planes(cells, layers_);
  middle_ = std::make_unique<Lattice>(middle, tables_->of(Band::middle, middle.lattice()), layers_,
                                      *tables_);
  const NodePlanes far = tables_->far_planes(middle, layers_);
  const auto of_far = tables_->of(Band::far, far.lattice());
  // Its images need the strain of all layers.
  far_ = std::make_unique<Lattice>(far, of_far, of_far->grid().nz, *tables_);
  find_rows();
  far_strain_ = tables_->borrow(far_->plane_size() * count(tensor_) * far_->layers());
  far_stress_ = tables_->borrow(far_->planes.sheet_size() * count(tensor_) * layers_);
  stress_ = tables_->borrow(count(tensor_) * cells_);
}

void LowBands::find_rows() {
  for (int k = 0; k < layers_; ++k) {
    std::vector<Box> in_middle, in_far;
    for (const Box& zone : zones_) {
      if (k >= zone.nz) continue;
      in_middle.push_back(middle_->nodes().reached(zone));
      in_far.push_back(far_->nodes().reached(in_middle.back()));
    }
    middle_->rows.push_back(middle_->planes.rows_of(in_middle));
    far_->rows.push_back(far_->planes.rows_of(in_far));
  }
}

LowBands::~LowBands() {
  for (Field* field :
       {&middle_->spectrum.data, &far_->spectrum.data, &far_strain_, &far_stress_, &stress_}) {
    tables_->give_back(std::move(*field));
  }
}

void LowBands::spread_layer(int k, const Field& strain) {
  const int parts = count(tensor_);
  const std::size_t sheet = middle_->planes.sheet_size();
  double* sheets = of_zeros(parts * sheet);
  bool any = false;
  for (std::size_t z = 0; z < zones_.size(); ++z) {
    if (k >= zones_[z].nz) continue;
    any = true;
    for (int c = 0; c < parts; ++c) {
      const double* from = strain.data() + c * cells_ + first_[z] + k * zones_[z].surface_size();
      middle_->nodes().spread(from, zones_[z].ny, zones_[z], sheets + c * sheet,
                              middle_->planes.sheet().ny);
    }
  }
  middle_->spectrum.used[k] = any;
  if (!any) return;
  const NodePlanes& planes = middle_->planes;
  const std::size_t plane = planes.plane_size();
  Field folded;
  const double* nodes = sheets;
  if (planes.is_periodic()) {
    folded.assign(parts * plane, 0.0);
    for (int c = 0; c < parts; ++c) planes.fold(sheets + c * sheet, folded.data() + c * plane);
    nodes = folded.data();
  }
  for (int c = 0; c < parts; ++c) {
    far_->planes.spread(nodes + c * plane, planes.pitch(), planes.own(),
                        far_strain_.data() + (static_cast<std::size_t>(c) * far_->layers() + k) *
                                                 far_->plane_size());
  }
  forward(middle_->operators->transform(), nodes, middle_->spectrum, k);
}

void LowBands::transform(const Field& strain) {
  check_interrupt();
  std::fill(far_strain_.begin(), far_strain_.end(), 0.0);
#pragma omp parallel for schedule(dynamic)
  for (int k = 0; k < layers_; ++k) spread_layer(k, strain);
  forward(far_->operators->transform(), far_strain_.data(), far_->spectrum);
}

void LowBands::add_displacement(Axis axis, double* out) const {
  Field middle(middle_->plane_size()), far(far_->plane_size()), far_room, middle_room;
  far_->operators->residual_displacement(axis).apply(far_->spectrum, far.data());
  middle_->operators->residual_displacement(axis).apply(middle_->spectrum, middle.data());
  gather(far_->planes.sheet_of(far.data(), far_room),
         middle_->planes.sheet_of(middle.data(), middle_room), Box::surface(grid_), out);
}

void LowBands::gather(const double* far, const double* middle, const Box& box,
                      double* cells) const {
  const Box nodes = middle_->nodes().reached(box);
  Field sum(nodes.surface_size());
  extract(middle, middle_->planes.sheet(), sum.data(), nodes);
  far_->nodes().gather(far, far_->planes.sheet(), nodes, sum.data());
  middle_->nodes().gather(sum.data(), nodes, box, cells);
}

void LowBands::find_stress(bool strained, const Tractions& tractions, double shear_sign) {
  const int parts = count(tensor_);
  const NodePlanes &nodes = middle_->planes, &far_nodes = far_->planes;
  const std::size_t middle = nodes.plane_size(), far = far_nodes.sheet_size();
  const Tractions on_middle = spread(tractions, Box::surface(grid_), grid_.ny, nodes);
  const Tractions on_far = spread(on_middle, nodes.own(), nodes.pitch(), far_nodes);
  if (!strained) {
    for (Lattice* lattice : {middle_.get(), far_.get()}) {
      std::fill(lattice->spectrum.data.begin(), lattice->spectrum.data.end(), 0.0);
    }
  }
  const double* some = strained ? far_strain_.data() : nullptr;
  far_->operators->for_each_layer(
      far_->spectrum, some, &on_far, shear_sign,
      [&](int k, const double* stress) {
        Field room;
        for (int c = 0; c < parts; ++c) {
          std::copy_n(far_nodes.sheet_of(stress + c * far_nodes.plane_size(), room), far,
                      far_stress_.data() + (static_cast<std::size_t>(k) * parts + c) * far);
        }
      },
      layers_, [&](int k) { return std::span<const fft::RowRun>(far_->rows[k]); });
  middle_->operators->for_each_layer(
      middle_->spectrum, some, &on_middle, shear_sign,
      [&](int k, const double* stress) {
        Field room;
        for (int c = 0; c < parts; ++c) {
          const double* sheet = nodes.sheet_of(stress + c * middle, room);
          const double* of_far =
              far_stress_.data() + (static_cast<std::size_t>(k) * parts + c) * far;
          for (std::size_t z = 0; z < zones_.size(); ++z) {
            if (k >= zones_[z].nz) continue;
            const std::size_t size = zones_[z].surface_size();
            double* to = stress_.data() + c * cells_ + first_[z] + k * size;
            std::fill_n(to, size, 0.0);
            gather(of_far, sheet, zones_[z], to);
          }
        }
      },
      layers_, [&](int k) { return std::span<const fft::RowRun>(middle_->rows[k]); });
}

}  // namespace samcontact::operators
