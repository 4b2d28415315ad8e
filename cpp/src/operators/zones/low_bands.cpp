// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/zones/low_bands.hpp"

#include <algorithm>
#include <cassert>
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
        spectrum(tables.borrow_spectrum(operators->transform(), layers, operators->tensor())) {}

  std::vector<std::vector<fft::RowRun>> rows;  // that zones read, by layer

  const NodeSpread& nodes() const { return planes.nodes(); }
  std::size_t plane_size() const { return planes.plane_size(); }
  int layers() const { return spectrum.nz; }

  /// Stores the stress of a layer [component][node] in the place of its spectrum, which is used up.
  void keep(int layer, const double* stress);
  /// Stored stress of the nodes of a box.
  void cut(int component, int layer, const Box& box, double* to) const;
};

void LowBands::Lattice::keep(int layer, const double* stress) {
  const std::size_t size = plane_size(), length = spectrum.row_size();
  for (int c = 0; c < spectrum.components; ++c) {
    for (std::size_t at = 0; at < size; at += length) {
      std::copy_n(stress + c * size + at, std::min(length, size - at),
                  spectrum.row(static_cast<int>(at / length), c, layer));
    }
  }
}

void LowBands::Lattice::cut(int component, int layer, const Box& box, double* to) const {
  const std::size_t length = spectrum.row_size();
  planes.for_each_piece(box, [&](std::size_t in_box, std::size_t in_plane, std::size_t count) {
    while (count > 0) {
      const std::size_t place = in_plane % length, some = std::min(length - place, count);
      std::copy_n(spectrum.row(static_cast<int>(in_plane / length), component, layer) + place, some,
                  to + in_box);
      in_box += some;
      in_plane += some;
      count -= some;
    }
  });
}

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
  for (Field* field : {&middle_->spectrum.data, &far_->spectrum.data, &far_strain_}) {
    tables_->give_back(std::move(*field));
  }
}

void LowBands::lend() {
  for (Lattice* lattice : {middle_.get(), far_.get()}) {
    tables_->give_back(std::exchange(lattice->spectrum.data, Field{}));
  }
}

void LowBands::take_back() {
  for (Lattice* lattice : {middle_.get(), far_.get()}) {
    VolumeSpectrum& spectrum = lattice->spectrum;
    if (spectrum.data.empty()) spectrum.data = tables_->borrow(spectrum.mh * spectrum.stride());
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
  take_back();
  std::fill(far_strain_.begin(), far_strain_.end(), 0.0);
#pragma omp parallel for schedule(dynamic)
  for (int k = 0; k < layers_; ++k) spread_layer(k, strain);
  forward(far_->operators->transform(), far_strain_.data(), far_->spectrum);
}

void LowBands::add_displacement(Axis axis, double* out) const {
  Field middle(middle_->plane_size()), far(far_->plane_size()), far_room, middle_room;
  far_->operators->residual_displacement(axis).apply(far_->spectrum, far.data());
  middle_->operators->residual_displacement(axis).apply(middle_->spectrum, middle.data());
  const Box box = Box::surface(grid_), nodes = middle_->nodes().reached(box);
  Field sum(nodes.surface_size());
  extract(middle_->planes.sheet_of(middle.data(), middle_room), middle_->planes.sheet(), sum.data(),
          nodes);
  far_->nodes().gather(far_->planes.sheet_of(far.data(), far_room), far_->planes.sheet(), nodes,
                       sum.data());
  middle_->nodes().gather(sum.data(), nodes, box, out);
}

void LowBands::find_stress(bool strained, const Tractions& tractions, double shear_sign) {
  assert(!strained || !middle_->spectrum.data.empty());
  const NodePlanes& nodes = middle_->planes;
  const Tractions on_middle = spread(tractions, Box::surface(grid_), grid_.ny, nodes);
  const Tractions on_far = spread(on_middle, nodes.own(), nodes.pitch(), far_->planes);
  if (!strained) {
    take_back();
    for (Lattice* lattice : {middle_.get(), far_.get()}) {
      std::fill(lattice->spectrum.data.begin(), lattice->spectrum.data.end(), 0.0);
    }
  }
  const double* some = strained ? far_strain_.data() : nullptr;
  const auto find = [&](Lattice& lattice, const Tractions& on) {
    lattice.operators->for_each_layer(
        lattice.spectrum, some, &on, shear_sign,
        [&](int k, const double* stress) { lattice.keep(k, stress); }, layers_,
        [&](int k) { return std::span<const fft::RowRun>(lattice.rows[k]); });
  };
  find(*far_, on_far);
  find(*middle_, on_middle);
}

void LowBands::stress(std::size_t zone, int layer, double* out) const {
  const Box& box = zones_[zone];
  const Box nodes = middle_->nodes().reached(box), far_nodes = far_->nodes().reached(nodes);
  Field sum(nodes.surface_size()), far(far_nodes.surface_size());
  const std::size_t size = box.surface_size();
  std::fill_n(out, count(tensor_) * size, 0.0);
  for (int c = 0; c < count(tensor_); ++c) {
    middle_->cut(c, layer, nodes, sum.data());
    far_->cut(c, layer, far_nodes, far.data());
    far_->nodes().gather(far.data(), far_nodes, nodes, sum.data());
    middle_->nodes().gather(sum.data(), nodes, box, out + c * size);
  }
}

}  // namespace samcontact::operators
