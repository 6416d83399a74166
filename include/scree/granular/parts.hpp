// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../formulation/combined.hpp"
#include "../formulation/formulation.hpp"
#include "granular.hpp"

#include <string>
#include <string_view>
#include <type_traits>

// The parts of a formulation as text. The text reveals an alias with a misspelt name, which changes no part.
namespace scree {
namespace detail {

template <class T>
std::string name_of_type() {
  std::string_view const text = __PRETTY_FUNCTION__;
  auto const start = text.find("T = ") + 4, end = text.find_first_of(";]", start);
  return std::string(text.substr(start, end - start));
}
template <class T>
std::string part(char const* role) {
  return std::string("  ") + role + ": " + name_of_type<T>() + "\n";
}

template <class Physics, int dim>
struct PartsOfPhysics {
  static std::string text() { return ""; }
};
template <class Models, int dim>
struct PartsOfPhysics<Granular<Models>, dim> {
  static std::string section() {
    if constexpr (TakesSection<typename Models::law>)
      return part<typename Granular<Models>::template section_in<dim>>("section");
    else
      return "";
  }
  static std::string text() {
    return part<typename Models::law>("law") + section() + part<typename Models::filter>("filter") +
           part<typename Granular<Models>::Volume>("volume_control") + part<typename Models::walls>("walls") +
           part<typename Models::viscosity>("viscosity") + part<typename Models::strain>("strain") +
           part<typename Models::forces>("forces") + part<typename Models::advection>("advection");
  }
};
template <class Mechanics, class Transport, int dim>
struct PartsOfPhysics<Combined<Mechanics, Transport>, dim> {
  static std::string text() { return PartsOfPhysics<Mechanics, dim>::text() + PartsOfPhysics<Transport, dim>::text(); }
};
template <class... Parts, int dim>
struct PartsOfPhysics<PhysicsOfBodies<Parts...>, dim> {
  static std::string text() {
    return (std::string() + ... +
            (part<typename Parts::type>(("physics of " + std::string(Parts::body::name)).c_str()) +
             PartsOfPhysics<typename Parts::type, dim>::text()));
  }
};

}  // namespace detail

/// Returns the classes that a formulation names, including defaults, one per line: " kernel: scree::WendlandC2". The
/// models of Granular are last.
template <class P>
std::string parts_of() {
  using namespace detail;
  return part<typename P::physics>("physics") + part<typename P::kernel>("kernel") +
         part<typename P::template search<basis_of<P>>>("search") + part<typename P::integrator>("integrator") +
         part<typename P::motion>("motion") + part<typename P::diagnostics>("diagnostics") +
         part<typename P::carries>("carries") + PartsOfPhysics<typename P::physics, P::dim>::text();
}
/// Returns the classes that the formulation of a solver names, including defaults, one per line.
template <class S>
std::string parts_of(S const&) {
  return parts_of<typename S::policy>();
}

}  // namespace scree
