// SPDX-License-Identifier: GPL-3.0-or-later
// Conversion of described data of the core to a dictionary of numbers, arrays and dictionaries, and
// back.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>
#include <ranges>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "samcontact/base/box.hpp"
#include "samcontact/simulation/cells/zones.hpp"
#include "typed.hpp"

namespace samcontact::bindings {

namespace py = pybind11;

/// Field or list, converted to an array of one dimension.
template <class T>
concept Sequence = requires(T part) { part.resize(0); };
/// List of records of a few integers, converted to an array of two dimensions.
template <class T>
concept Rows = Sequence<T> && (std::is_same_v<typename T::value_type, Box> ||
                               std::is_same_v<typename T::value_type, simulation::Cell>);

template <Rows T>
constexpr std::size_t columns = sizeof(typename T::value_type) / sizeof(int);

template <Rows T>
py::array_t<std::int64_t> rows_of(const T& part) {
  const std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(part.size()), columns<T>};
  py::array_t<std::int64_t> rows(shape);
  for (std::size_t n = 0; n < part.size(); ++n) {
    const auto numbers = std::bit_cast<std::array<int, columns<T>>>(part[n]);
    std::copy(numbers.begin(), numbers.end(), rows.mutable_data(n, 0));
  }
  return rows;
}

/// Throws std::invalid_argument unless each row has the right number of integers, in range.
template <Rows T>
void read_rows(const std::string& name, const py::object& kept, T& part) {
  const auto rows = kept.cast<py::array_t<std::int64_t, py::array::c_style>>();
  const bool fits = rows.ndim() == 2 && rows.shape(1) == columns<T> &&
                    std::all_of(rows.data(), rows.data() + rows.size(),
                                [](std::int64_t number) { return std::in_range<int>(number); });
  if (!fits)
    throw std::invalid_argument(name + " must be an array of integers with " +
                                std::to_string(columns<T>) + " columns");
  part.resize(rows.shape(0));
  for (std::size_t n = 0; n < part.size(); ++n) {
    std::array<int, columns<T>> numbers;
    std::copy_n(rows.data(n, 0), columns<T>, numbers.begin());
    part[n] = std::bit_cast<typename T::value_type>(numbers);
  }
}

template <class T>
py::array_t<typename T::value_type> array_of(const T& part, const py::object& owner) {
  using Numbers = py::array_t<typename T::value_type>;
  const auto size = static_cast<py::ssize_t>(part.size());
  if (owner.is_none()) return Numbers(size, part.data());
  Numbers view(size, part.data(), owner);
  py::detail::array_proxy(view.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return view;
}

/// Visitor that stores all described parts, or the part of one name. Empty sequences are omitted.
class PartWriter {
 public:
  /// owner: Python object that owns the visited data, for views of its sequences; None: copies.
  explicit PartWriter(std::string only = {}, py::object owner = py::none())
      : only_(std::move(only)), owner_(std::move(owner)) {}

  template <class T>
  void operator()(const std::string& name, const T& part) {
    if (!is_selected(name)) return;
    if constexpr (Sequence<T>) {
      if (part.empty()) return;
    }
    content[name.c_str()] = to_python(part, owner_);
  }
  void maybe_nan(const std::string& name, double part) { (*this)(name, part); }

  template <class T, class Plain, class Make>
  void made(const std::string& name, const std::shared_ptr<const T>& part, const Plain& plain,
            const Make&) {
    if (is_selected(name) && part) content[name.c_str()] = to_python(plain(*part), py::none());
  }

  Content content;

  template <class T>
  static auto to_python(const T& part, const py::object& owner) {
    if constexpr (Rows<T>) {
      return rows_of(part);
    } else if constexpr (Sequence<T>) {
      return array_of(part, owner);
    } else if constexpr (std::is_enum_v<T>) {
      return static_cast<int>(part);
    } else if constexpr (std::is_same_v<T, Box>) {
      return std::array{part.i0, part.j0, part.nx, part.ny, part.nz};
    } else if constexpr (requires(PartWriter visit) { describe(part, visit); }) {
      PartWriter inner;
      describe(part, inner);
      return std::move(inner.content);
    } else {
      return part;
    }
  }

 private:
  bool is_selected(const std::string& name) const { return only_.empty() || name == only_; }

  std::string only_;
  py::object owner_;
};

/// Visitor that fills the described parts. Throws std::invalid_argument for a part that is missing
/// or has the wrong type, and for numbers that are not finite.
class PartReader {
 public:
  explicit PartReader(const py::dict& content) : left_(content.attr("copy")()) {}

  /// Throws std::invalid_argument if an unknown part is left.
  void require_no_more() const {
    if (left_.empty()) return;
    throw std::invalid_argument("unknown part '" + py::str(*py::iter(left_)).cast<std::string>() +
                                "'");
  }

  template <class T>
  void operator()(const std::string& name, T& part) {
    read(name, part);
    if constexpr (std::is_same_v<T, double>) {
      require_finite(name, std::isfinite(part));
    } else if constexpr (std::ranges::range<T> && !Rows<T>) {
      require_finite(name, std::all_of(part.begin(), part.end(),
                                       [](double number) { return std::isfinite(number); }));
    }
  }
  void maybe_nan(const std::string& name, double& part) { read(name, part); }

  template <class T, class Plain, class Make>
  void made(const std::string& name, std::shared_ptr<const T>& part, const Plain& plain,
            const Make& make) {
    part = nullptr;
    if (!left_.contains(name)) return;
    std::decay_t<decltype(plain(*part))> kept;
    (*this)(name, kept);
    part = make(kept);
  }

 private:
  static void require_finite(const std::string& name, bool holds) {
    if (!holds) throw std::invalid_argument(name + " must be finite");
  }
  template <class T>
  void read(const std::string& name, T& part) {
    if (left_.contains(name)) {
      try {
        const auto kept = left_.attr("pop")(name);
        if constexpr (Rows<T>) {
          read_rows(name, kept, part);
        } else {
          from_python(kept, part);
        }
      } catch (const py::cast_error&) {
        throw std::invalid_argument(name + " has the wrong type");
      }
    } else if constexpr (Sequence<T>) {
      part.clear();
    } else {
      throw std::invalid_argument(name + " is missing");
    }
  }
  template <class T>
  static void from_python(const py::object& kept, T& part) {
    if constexpr (Sequence<T>) {
      const auto array = kept.cast<py::array_t<typename T::value_type, py::array::c_style>>();
      part.assign(array.data(), array.data() + array.size());
    } else if constexpr (std::is_enum_v<T>) {
      part = static_cast<T>(kept.cast<int>());
    } else if constexpr (std::is_same_v<T, Box>) {
      const auto numbers = kept.cast<std::array<int, 5>>();
      part = {numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]};
    } else if constexpr (requires(PartReader visit) { describe(part, visit); }) {
      PartReader inner(kept.cast<py::dict>());
      describe(part, inner);
      inner.require_no_more();
    } else {
      part = kept.cast<T>();
    }
  }

  py::dict left_;  // parts that have not been read yet
};

}  // namespace samcontact::bindings
