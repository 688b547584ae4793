// Checks the entries of the plate against each other and against its file.
#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"
#include "plate_impact/plate/plate_file.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_section.h"
#include "plate_impact/scene/scene_checker.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace PlateImpact
{
  bool
  SceneChecker::read_plate()
  {
    if (!plate.is_from_file())
      return true;
    if (!plate.file || plate.file->path != plate.outline.file)
      try
        {
          plate.file = read_plate_file(plate.outline.file);
        }
      catch (const InputError &error)
        {
          refuse({"Plate/Outline"}, error.what());
          // what else is wrong can be said of a rectangle
          plate.outline.shape = PlateOutline::rectangle;
          return false;
        }
    // the file's own lengths count; those given tell another unit
    const auto &[a, b] = plate.file->extent;
    const double ratio =
      std::max(a, b) / std::max(plate.side_lengths[0], plate.side_lengths[1]);
    if (is_given("Plate/Side lengths") && (ratio > 50. || ratio < 0.02))
      refuse({"Plate/Side lengths", "Plate/Outline"},
             "m are far from the " + number(a) + " x " + number(b) + " m of " +
               plate.outline.file +
               ", which may be in other units; expected a file in metres, and "
               "no side lengths beside it");
    return true;
  }



  void
  SceneChecker::check_section()
  {
    if (!plate.is_laminate())
      {
        // one that is given empty is meant: a sweep may compare with it
        if (!is_given("Plate/Layup"))
          for (const Entry &entry : entries.all)
            if (entry.section() == "Ply" && entry.value != entry.default_value)
              refuse({entry.path, "Plate/Layup"},
                     "is an entry of plies, but there is no lay-up; expected "
                     "one in Plate/Layup");
        return;
      }
    for (const std::string path : {"Plate/Young's modulus",
                                   "Plate/Poisson's ratio",
                                   "Plate/Yield strength"})
      if (entries.at(path).value != entries.at(path).default_value)
        refuse({path, "Plate/Layup"},
               "is an entry of isotropic plates, but there is a lay-up; "
               "expected the entries of section Ply only");
    const PlyParameters &ply = plate.ply;
    const double         largest =
      std::sqrt(ply.longitudinal_modulus / ply.transverse_modulus);
    if (std::abs(ply.poissons_ratio) >= largest)
      return refuse({"Ply/Poisson's ratio",
                     "Ply/Longitudinal modulus",
                     "Ply/Transverse modulus"},
                    "makes the stiffness of the ply indefinite; expected a "
                    "magnitude below the square root of Longitudinal modulus / "
                    "Transverse modulus, " +
                      number(largest));
    // the law Sun takes nothing from across the plate, not even by equilibrium
    if (contact.law != ForceLaw::Sun)
      {
        if (!is_given("Plate/Shear correction factor"))
          choose("Plate/Shear correction factor",
                 plate.shear_correction_factor,
                 0.);
        check_ply();
      }
    plate.is_skew = PlateSection(plate).is_skew();
  }



  void
  SceneChecker::check_ply()
  {
    const Ply    ply(plate.ply);
    const double derived = ply.constants.transverse_poissons_ratio;
    if (plate.ply.transverse_poissons_ratio == 0. &&
        !(derived >= 0. && derived <= 0.6))
      return refuse({"Ply/Transverse Poisson's ratio",
                     "Ply/Transverse modulus",
                     "Ply/Transverse shear modulus"},
                    "is derived as Transverse modulus / (2 Transverse shear "
                    "modulus) - 1 = " +
                      number(derived) +
                      ", which no fibre composite has; expected nu_23 itself, "
                      "usually 0.2 to 0.5, or moduli that give 0 to 0.6");
    if (!ply.is_elastic())
      refuse({"Ply/Transverse Poisson's ratio",
              "Ply/Through-thickness Poisson's ratio",
              "Ply/Poisson's ratio",
              "Ply/Through-thickness modulus",
              "Ply/Longitudinal modulus",
              "Ply/Transverse modulus"},
             "makes the stiffness of the ply indefinite; expected Poisson's "
             "ratios with which it is positive definite");
  }



  template <typename Supports>
  void
  SceneChecker::check_edges(const std::string &entry, const Supports &supports)
  {
    std::vector<std::string> named;
    for (const auto &support : supports)
      named.push_back(support.edge);
    const bool is_named = !named.front().empty();
    if (!plate.is_from_file())
      {
        if (is_named)
          refuse({entry, "Plate/Outline"},
                 "names edges, which only an outline from a file has; expected "
                 "one word, or two for the x and the y edges");
        else if (plate.is_circle() && named.size() > 1)
          refuse({entry, "Plate/Outline"},
                 "are two supports, and a circle has one edge; expected one "
                 "word");
        return;
      }
    const auto              &edges = plate.file->edges;
    std::vector<std::string> quoted;
    for (const std::string &edge : edges)
      quoted.push_back(edge.empty() ? "sides in no physical group" :
                                      "'" + edge + "'");
    const std::string names = fmt::format("{}", fmt::join(quoted, ", "));
    if (!is_named && named.size() > 1)
      return refuse({entry, "Plate/Outline"},
                    "are two supports without edges; expected one word, or "
                    "pairs edge: word for the edges of " +
                      plate.outline.file + ", " + names);
    if (!is_named)
      return;
    for (const std::string &edge : named)
      if (std::count(edges.begin(), edges.end(), edge) == 0)
        refuse({entry, "Plate/Outline"},
               "names an edge '" + edge + "', which " + plate.outline.file +
                 " does not have; expected " + names);
      else if (std::count(named.begin(), named.end(), edge) > 1)
        return refuse({entry}, "names the edge '" + edge + "' twice");
    for (const std::string &edge : edges)
      if (std::count(named.begin(), named.end(), edge) == 0)
        refuse({entry, "Plate/Outline"},
               edge.empty() ?
                 "names no support for sides of " + plate.outline.file +
                   " that belong to no physical group; expected a group for "
                   "every edge, or one word" :
                 "names no support for the edge '" + edge + "' of " +
                   plate.outline.file + "; expected one for each of " + names);
  }



  void
  SceneChecker::check_shape()
  {
    const auto  &geometry = geometry_of(plate);
    const double a = geometry.side_lengths[0], b = geometry.side_lengths[1];
    const double half_side = 0.5 * std::min(a, b);
    if (plate.thickness > half_side)
      refuse({"Plate/Thickness", "Plate/Side lengths"},
             "m is too thick for a plate theory; expected at most half the "
             "shorter side, " +
               number(half_side) + " m");
    check_edges("Plate/Support", plate.supports);
    check_edges("Plate/In-plane support", plate.in_plane_supports);
    const double to_edge =
      has_impactor() ? geometry.distance_to_edge : half_side;
    if (to_edge <= 0. && plate.is_from_file())
      return refuse({"Plate/Impact point", "Plate/Outline"},
                    "m lies outside of the plate of " + plate.outline.file +
                      ", or on an edge; expected a point from the middle of "
                      "its " +
                      number(a) + " x " + number(b) + " m");
    if (to_edge <= 0.)
      return refuse({"Plate/Impact point", "Plate/Side lengths"},
                    "m lies outside of the plate; expected less than " +
                      (plate.is_circle() ? "its radius, " + number(0.5 * a) +
                           " m, from the centre" :
                                           "half of the sides, " +
                           number(0.5 * a) + ", " + number(0.5 * b) + " m"));
    if (contact.has_patch() && contact.patch_radius > to_edge)
      refuse({"Contact/Patch radius",
              "Plate/Side lengths",
              "Plate/Impact point"},
             "m reaches beyond the plate; expected at most the distance to the "
             "nearest edge, " +
               number(to_edge) + " m");
    if (plate.outline.shape != PlateOutline::rectangle &&
        adaptivity.strategy == AdaptationStrategy::remeshing)
      refuse({"Adaptivity/Strategy", "Plate/Outline"},
             "makes meshes of rectangles only; expected another strategy for "
             "this outline, for example hanging nodes");
  }
} // namespace PlateImpact
