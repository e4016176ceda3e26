// SPDX-License-Identifier: MIT
// Parameters, laws and moduli of each pair of types, from 1 on, as a host's commands set them.
#pragma once

#include <cstdio>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "../laws.hpp"

namespace contactlaws {

template <class Parameters>
struct TypePair {
  Parameters parameters;
  LawOf<Parameters> law;
  EffectiveModuli<double> moduli{1.0, 1.0};  ///< not read by laws of linear springs
  double wet_gap = -1.0;                     ///< < 0: wets nothing [m]
};

/// Entry: a TypePair, with what the host keeps beside it.
template <class Parameters, class Entry>
class TypePairs {
 public:
  void resize(int types) {
    row_ = std::size_t(types + 1);
    materials_.assign(row_, no_material());
    entries_.resize(row_ * (row_ - 1) / 2);
    of_types_.assign(row_ * row_, nullptr);
    std::size_t next = 0;
    for (std::size_t i = 1; i < row_; ++i)
      for (std::size_t j = i; j < row_; ++j) of_types_[i * row_ + j] = of_types_[j * row_ + i] = &entries_[next++];
  }
  Entry& operator()(int i, int j) const { return *of_types_[std::size_t(i) * row_ + std::size_t(j)]; }
  /// Those of type i with each other type.
  Entry* const* of(int i) const { return &of_types_[std::size_t(i) * row_]; }
  auto begin() { return entries_.begin(); }
  auto end() { return entries_.end(); }

  /// young and poisson are those of type i. @throws std::invalid_argument naming what is wrong, as does prepare()
  void set(int i, int j, const std::string& name, double value) {
    if (name == "young" || name == "poisson") {
      set_parameter(materials_[std::size_t(i)], name, value);
    } else if (has_bridge<LawOf<Parameters>> && name == "wet") {
      require_in(Range::not_negative(), value, "pair_coeff", "wet", "m");
      (*this)(i, j).wet_gap = value;
    } else {
      set_law_parameter((*this)(i, j).parameters, name, value,
                        std::string("young, poisson") + (has_bridge<LawOf<Parameters>> ? ", wet" : ""));
    }
  }
  /// Makes law and moduli of what is set.
  void prepare(int i, int j) {
    Entry& entry = (*this)(i, j);
    entry.law = make_law(entry.parameters);
    if (reads_moduli<Parameters>) entry.moduli = given_moduli(materials_[std::size_t(i)], materials_[std::size_t(j)]);
  }

  /// transfer(values, bytes) for all that commands have set: into a restart file, or from it.
  template <class Transfer>
  void transfer(const Transfer& transfer) {
    static_assert(std::is_trivially_copyable_v<Parameters>);
    transfer(materials_.data(), sizeof(materials_[0]) * materials_.size());
    for (Entry& entry : entries_) {
      transfer(&entry.parameters, sizeof(Parameters));
      transfer(&entry.wet_gap, sizeof(double));
    }
  }

 private:
  std::size_t row_ = 0;
  std::vector<ElasticMaterial<double>> materials_;  ///< of each type
  std::vector<Entry> entries_;
  std::vector<Entry*> of_types_;
};

}  // namespace contactlaws
