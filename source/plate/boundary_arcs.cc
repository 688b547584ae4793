// Round edges of a plate from a file.
#include <deal.II/base/bounding_box.h>
#include <deal.II/base/numbers.h>
#include <deal.II/grid/manifold_lib.h>

#include "plate_impact/plate/plate_file.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace PlateImpact
{
  using namespace dealii;

  namespace
  {
    using Side = Triangulation<2>::face_iterator;

    /// The sides of the plate that meet at a vertex.
    using SidesAt = std::map<unsigned int, std::vector<Side>>;



    /// The circle that fits the ends of sides best in the sense of Kasa: x^2 +
    /// y^2 is linear in x and y on it.
    Arc
    fitted_circle(const std::vector<Side> &sides)
    {
      // from one of them, for the sake of rounding
      const Point<2>  origin = sides.front()->vertex(0);
      Eigen::MatrixXd A(2 * sides.size(), 3);
      Eigen::VectorXd b(A.rows());
      for (Eigen::Index i = 0; i < A.rows(); ++i)
        {
          const Tensor<1, 2> p = sides[i / 2]->vertex(i % 2) - origin;
          A.row(i) << 2. * p[0], 2. * p[1], 1.;
          b[i] = p.norm_square();
        }
      const Eigen::Vector3d c = A.colPivHouseholderQr().solve(b);
      return {origin + Point<2>(c[0], c[1]),
              std::sqrt(std::max(0., c[2] + c[0] * c[0] + c[1] * c[1]))};
    }



    /// Whether a side is a chord of the circle, one of nine or more to a turn:
    /// a polygon of fewer sides is taken for one.
    bool
    is_chord(const Side &side, const Arc &circle)
    {
      const double widest = 40.001 * numbers::PI / 180.;
      for (const unsigned int v : {0, 1})
        if (!(std::abs(side->vertex(v).distance(circle.centre) -
                       circle.radius) < 1e-5 * circle.radius))
          return false;
      return side->diameter() <= 2. * circle.radius * std::sin(0.5 * widest);
    }



    /// The side of the same edge beyond an end of a side.
    std::optional<Side>
    side_beyond(const SidesAt     &sides_at,
                const Side        &side,
                const unsigned int end)
    {
      const auto &here = sides_at.at(side->vertex_index(end));
      if (here.size() != 2)
        return {};
      const Side &other = here[0] == side ? here[1] : here[0];
      return other->boundary_id() == side->boundary_id() ?
        std::optional(other) :
        std::nullopt;
    }



    /// The chords of a circle around a side, one after the other.
    std::vector<Side>
    chords(const SidesAt &sides_at, const Side &side, const Arc &circle)
    {
      std::vector<Side> row = {side};
      for (std::size_t i = 0; i < row.size(); ++i)
        for (const unsigned int end : {0, 1})
          if (const auto beyond = side_beyond(sides_at, row[i], end); beyond &&
              is_chord(*beyond, circle) &&
              std::find(row.begin(), row.end(), *beyond) == row.end())
            row.push_back(*beyond);
      return row;
    }
  } // namespace



  std::vector<Arc>
  find_arcs(Triangulation<2> &mesh)
  {
    SidesAt sides_at;
    for (const auto &face : mesh.active_face_iterators())
      if (face->at_boundary())
        for (const unsigned int v : {0, 1})
          sides_at[face->vertex_index(v)].push_back(face);
    const BoundingBox<2> box(mesh.get_vertices());
    const double         largest_radius =
      100. * std::max(box.side_length(0), box.side_length(1));

    std::vector<Arc> arcs;
    for (const auto &face : mesh.active_face_iterators())
      {
        if (!face->at_boundary() ||
            face->manifold_id() != numbers::flat_manifold_id)
          continue;
        const auto before = side_beyond(sides_at, face, 0),
                   after  = side_beyond(sides_at, face, 1);
        if (!before || !after || *before == *after)
          continue;
        const Arc circle = fitted_circle({*before, face, *after});
        if (!(circle.radius < largest_radius && is_chord(*before, circle) &&
              is_chord(face, circle) && is_chord(*after, circle)))
          continue;
        const auto row = chords(sides_at, face, circle);
        for (const Side &side : row)
          side->set_manifold_id(arcs.size());
        arcs.push_back(fitted_circle(row));
        mesh.set_manifold(arcs.size() - 1,
                          SphericalManifold<2>(arcs.back().centre));
      }
    return arcs;
  }
} // namespace PlateImpact
