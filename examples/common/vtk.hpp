// SPDX-License-Identifier: MIT
// Points and lines with data at each point as VTK's XML files (.vtp), and a run of them over time (.pvd). ParaView and PyVista
// open both.
#pragma once

#include <map>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "contactlaws/core/scalar.hpp"

namespace common {

/// Each field has a value for each point. A field that may be empty is named before the first point, so that no file of a run
/// lacks it.
struct VtkData {
  using Vector = contactlaws::Vec3<double>;
  enum class Shape {
    points,
    lines  ///< between points 0 and 1, 2 and 3, ...
  };

  Shape shape = Shape::points;
  std::vector<Vector> points;
  std::map<std::string, std::vector<double>> scalars;
  std::map<std::string, std::vector<Vector>> vectors;

  /// Numbers have 17 digits.
  void write(std::ostream& file) const {
    const std::size_t in_cell = shape == Shape::lines ? 2 : 1, cells = points.size() / in_cell;
    file.precision(17);
    file << "<VTKFile type=\"PolyData\" version=\"1.0\">\n<PolyData>\n<Piece NumberOfPoints=\"" << points.size()
         << "\" " << (shape == Shape::lines ? "NumberOfLines" : "NumberOfVerts") << "=\"" << cells
         << "\">\n<PointData>\n";
    for (const auto& [name, values] : scalars) write_array(file, "Float64", name, 1, values);
    for (const auto& [name, values] : vectors) write_array(file, "Float64", name, 3, values);
    file << "</PointData>\n<Points>\n";
    write_array(file, "Float64", "points", 3, points);
    file << "</Points>\n<" << name_of_cells() << ">\n";
    std::vector<std::size_t> connectivity(cells * in_cell), offsets(cells);
    for (std::size_t i = 0; i < connectivity.size(); ++i) connectivity[i] = i;
    for (std::size_t i = 0; i < cells; ++i) offsets[i] = (i + 1) * in_cell;
    write_array(file, "Int64", "connectivity", 1, connectivity);
    write_array(file, "Int64", "offsets", 1, offsets);
    file << "</" << name_of_cells() << ">\n</Piece>\n</PolyData>\n</VTKFile>\n";
  }

 private:
  const char* name_of_cells() const { return shape == Shape::lines ? "Lines" : "Verts"; }

  template <class Values>
  static void write_array(std::ostream& file, const char* type, const std::string& name, int components,
                          const Values& values) {
    file << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\"" << components
         << "\" format=\"ascii\">\n";
    for (const auto& value : values) write_value(file, value);
    file << "</DataArray>\n";
  }
  static void write_value(std::ostream& file, const Vector& v) {
    file << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
  }
  template <class Number>
  static void write_value(std::ostream& file, const Number& number) {
    file << number << '\n';
  }
};

/// Files and their times [s], to be opened as one.
struct VtkSeries {
  std::vector<std::pair<double, std::string>> files;  ///< relative to the folder of the .pvd file

  void write(std::ostream& file) const {
    file << "<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
    for (const auto& [time, name] : files)
      file << "<DataSet timestep=\"" << time << "\" part=\"0\" file=\"" << name << "\"/>\n";
    file << "</Collection>\n</VTKFile>\n";
  }
};

}  // namespace common
