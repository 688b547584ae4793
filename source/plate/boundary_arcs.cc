#include "plate_impact/plate/boundary_arcs.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

namespace PlateImpact
{
  namespace
  {
    /// The circle that fits points best in the sense of Kasa: x^2 + y^2 is
    /// linear in x and y on it.
    PlateFile::Arc
    fitted_circle(const std::vector<PlanePoint> &points)
    {
      Eigen::MatrixXd A(points.size(), 3);
      Eigen::VectorXd b(points.size());
      for (std::size_t i = 0; i < points.size(); ++i)
        {
          // from the first point, for the sake of rounding
          const double x = points[i][0] - points[0][0],
                       y = points[i][1] - points[0][1];
          A.row(i) << 2. * x, 2. * y, 1.;
          b[i] = x * x + y * y;
        }
      const Eigen::Vector3d c = A.colPivHouseholderQr().solve(b);
      return {{{points[0][0] + c[0], points[0][1] + c[1]}},
              std::sqrt(std::max(0., c[2] + c[0] * c[0] + c[1] * c[1]))};
    }



    /// Whether a side is a chord of the circle, one of nine or more to a turn:
    /// a polygon of fewer sides is taken for one.
    bool
    is_chord(const PlateFile       &plate,
             const PlateFile::Side &side,
             const PlateFile::Arc  &arc)
    {
      const auto lies_on = [&](const unsigned int v) {
        return std::abs(distance(plate.vertices[v], arc.centre) - arc.radius) <
          1e-5 * arc.radius;
      };
      const auto &[a, b] = side.vertices;
      const double angle = 40.001 * std::acos(-1.) / 180.;
      return lies_on(a) && lies_on(b) &&
        distance(plate.vertices[a], plate.vertices[b]) <=
        2. * arc.radius * std::sin(0.5 * angle);
    }



    /// The sides of the plate as a graph.
    class Boundary
    {
    public:
      explicit Boundary(const PlateFile &plate)
        : plate(plate)
      {
        for (unsigned int s = 0; s < plate.sides.size(); ++s)
          for (const unsigned int v : plate.sides[s].vertices)
            sides_at[v].push_back(s);
      }

      /// The side of the same edge beyond an end of a side.
      std::optional<unsigned int>
      next(const unsigned int side, const unsigned int end) const
      {
        const auto &here = sides_at.at(plate.sides[side].vertices[end]);
        if (here.size() != 2)
          return {};
        const unsigned int other = here[0] == side ? here[1] : here[0];
        return plate.sides[other].edge == plate.sides[side].edge ?
          std::optional(other) :
          std::nullopt;
      }

      /// The circle on which a side and its two neighbours are chords.
      std::optional<PlateFile::Arc>
      circle_at(const unsigned int side) const
      {
        const auto before = next(side, 0), after = next(side, 1);
        if (!before || !after || *before == *after)
          return {};
        const PlateFile::Arc circle =
          fitted_circle(points_of({*before, side, *after}));
        const bool is_arc =
          circle.radius < 100. * std::max(plate.extent[0], plate.extent[1]) &&
          is_chord(plate, plate.sides[*before], circle) &&
          is_chord(plate, plate.sides[side], circle) &&
          is_chord(plate, plate.sides[*after], circle);
        return is_arc ? std::optional(circle) : std::nullopt;
      }

      /// The chords of a circle around a side, one after the other.
      std::vector<unsigned int>
      chords(const unsigned int side, const PlateFile::Arc &circle) const
      {
        std::vector<unsigned int> row = {side};
        for (std::size_t i = 0; i < row.size(); ++i)
          for (const unsigned int end : {0, 1})
            if (const auto beyond = next(row[i], end); beyond &&
                is_chord(plate, plate.sides[*beyond], circle) &&
                std::find(row.begin(), row.end(), *beyond) == row.end())
              row.push_back(*beyond);
        return row;
      }

      std::vector<PlanePoint>
      points_of(const std::vector<unsigned int> &sides) const
      {
        std::vector<PlanePoint> points;
        for (const unsigned int s : sides)
          for (const unsigned int v : plate.sides[s].vertices)
            points.push_back(plate.vertices[v]);
        return points;
      }

    private:
      const PlateFile                                  &plate;
      std::map<unsigned int, std::vector<unsigned int>> sides_at;
    };
  } // namespace



  void
  find_arcs(PlateFile &plate)
  {
    const Boundary boundary(plate);
    for (unsigned int side = 0; side < plate.sides.size(); ++side)
      if (!plate.sides[side].arc)
        if (const auto circle = boundary.circle_at(side))
          {
            const auto row = boundary.chords(side, *circle);
            for (const unsigned int s : row)
              plate.sides[s].arc = plate.arcs.size();
            plate.arcs.push_back(fitted_circle(boundary.points_of(row)));
          }
  }
} // namespace PlateImpact
