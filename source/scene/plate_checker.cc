#include "plate_impact/scene/plate_checker.h"

#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/text.h"
#include "plate_impact/plate/plate_file.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_section.h"

#include <algorithm>
#include <cmath>

namespace PlateImpact
{
  PlateChecker::PlateChecker(const SceneSchema &schema,
                             Parameters        &scene,
                             SceneMistakes     &mistakes)
    : schema(schema)
    , scene(scene)
    , mistakes(mistakes)
  {}



  void
  PlateChecker::read()
  {
    PlateParameters &plate = scene.plate;
    if (!plate.is_from_file() ||
        (plate.file && plate.file->path == plate.outline.file))
      return;
    try
      {
        plate.file = read_plate_file(plate.outline.file);
      }
    catch (const InputError &error)
      {
        mistakes.refuse({"Plate/Outline"}, error.what());
        // what else is wrong can be said of a rectangle
        plate.outline.shape = PlateOutline::rectangle;
        is_unknown          = true;
      }
  }



  void
  PlateChecker::check_section()
  {
    PlateParameters &plate = scene.plate;
    if (!plate.is_laminate())
      {
        // one that is given empty is meant: a sweep may compare with it
        if (schema.origin("Plate/Layup") == "default" &&
            !mistakes.is_swept("Plate/Layup"))
          for (const std::string &path : schema.entries_of("Ply"))
            if (schema.is_changed(path))
              mistakes.refuse(
                {path, "Plate/Layup"},
                "is of a ply, and there is no lay-up; expected one in "
                "Plate/Layup");
        return;
      }
    for (const std::string path :
         {"Plate/Young's modulus", "Plate/Poisson's ratio"})
      if (schema.is_changed(path))
        mistakes.refuse(
          {path, "Plate/Layup"},
          "is of an isotropic plate, and there is a lay-up; expected the "
          "entries of section Ply alone");
    const PlyParameters &ply = plate.ply;
    const double         largest =
      std::sqrt(ply.longitudinal_modulus / ply.transverse_modulus);
    if (std::abs(ply.poissons_ratio) >= largest)
      return mistakes.refuse(
        {"Ply/Poisson's ratio",
         "Ply/Longitudinal modulus",
         "Ply/Transverse modulus"},
        "is not that of an elastic ply; expected a magnitude below "
        "the root of Longitudinal over Transverse modulus, " +
          number(largest));
    const PlateSection section(plate);
    if (section.is_unsymmetric())
      mistakes.refuse(
        {"Plate/Layup"},
        "is not symmetric, so that bending stretches the middle surface, "
        "for which the plate has no unknowns; expected a symmetric "
        "lay-up, as with an s at the end");
    plate.twists_when_bent = section.twists_when_bent();
  }



  void
  PlateChecker::check_edges()
  {
    const PlateParameters &plate    = scene.plate;
    const auto            &supports = plate.supports;
    const bool             is_named = !supports.front().edge.empty();
    if (!plate.is_from_file())
      {
        if (is_named)
          mistakes.refuse(
            {"Plate/Support", "Plate/Outline"},
            "names edges, which only an outline from a file has; expected "
            "one word, or two for the x and the y edges");
        else if (plate.is_circle() && supports.size() > 1)
          mistakes.refuse(
            {"Plate/Support", "Plate/Outline"},
            "are two supports, and a circle has one edge; expected one "
            "word");
        return;
      }
    const auto &edges = plate.file->edges;
    std::string names;
    for (const std::string &edge : edges)
      names += (names.empty() ? "" : ", ") +
        (edge.empty() ? "sides in no physical group" : "'" + edge + "'");
    if (!is_named && supports.size() > 1)
      return mistakes.refuse(
        {"Plate/Support", "Plate/Outline"},
        "are two supports without edges; expected one word, or "
        "pairs edge: word for the edges of " +
          plate.outline.file + ", " + names);
    if (!is_named)
      return;
    for (const auto &[name, support] : supports)
      if (std::count(edges.begin(), edges.end(), name) == 0)
        mistakes.refuse({"Plate/Support", "Plate/Outline"},
                        "names an edge '" + name + "', which " +
                          plate.outline.file + " does not have; expected " +
                          names);
      else if (std::count_if(supports.begin(),
                             supports.end(),
                             [&name = name](const EdgeSupports &other) {
                               return other.edge == name;
                             }) > 1)
        return mistakes.refuse({"Plate/Support"},
                               "names the edge '" + name + "' twice");
    for (const std::string &edge : edges)
      if (std::none_of(supports.begin(),
                       supports.end(),
                       [&edge](const EdgeSupports &named) {
                         return named.edge == edge;
                       }))
        mistakes.refuse(
          {"Plate/Support", "Plate/Outline"},
          edge.empty() ? "names no support for sides of " + plate.outline.file +
              " that belong to no physical group; expected a group for "
              "every edge, or one word" :
                         "names no support for the edge '" + edge + "' of " +
              plate.outline.file + "; expected one for each of " + names);
  }



  void
  PlateChecker::check_extent()
  {
    // the file's own lengths count; those given tell another unit
    const PlateParameters &plate = scene.plate;
    if (!plate.is_from_file() ||
        schema.origin("Plate/Side lengths") == "default")
      return;
    const double ratio =
      std::max(plate.file->extent[0], plate.file->extent[1]) /
      std::max(plate.side_lengths[0], plate.side_lengths[1]);
    if (ratio > 50. || ratio < 0.02)
      mistakes.refuse(
        {"Plate/Side lengths", "Plate/Outline"},
        "m are far from the " + number(plate.file->extent[0]) + " x " +
          number(plate.file->extent[1]) + " m of " + plate.outline.file +
          ", which may be in other units; expected a file in metres, and "
          "no side lengths beside it");
  }



  void
  PlateChecker::check_shape()
  {
    if (is_unknown)
      return;
    const PlateParameters &plate    = scene.plate;
    const auto             geometry = geometry_of(plate);
    const double           half_side =
      0.5 * std::min(geometry->side_length(0), geometry->side_length(1));
    if (plate.thickness > half_side)
      mistakes.refuse(
        {"Plate/Thickness", "Plate/Side lengths"},
        "m is too thick for a plate theory; expected at most half the "
        "shorter side, " +
          number(half_side) + " m");
    check_edges();
    check_extent();
    const double to_edge =
      scene.has_impactor() ? geometry->distance_to_edge() : half_side;
    if (to_edge <= 0. && plate.is_from_file())
      return mistakes.refuse(
        {"Plate/Impact point", "Plate/Outline"},
        "m lies outside of the plate of " + plate.outline.file +
          ", or on an edge; expected a point from the middle of "
          "its " +
          number(geometry->side_length(0)) + " x " +
          number(geometry->side_length(1)) + " m");
    if (to_edge <= 0.)
      return mistakes.refuse(
        {"Plate/Impact point", "Plate/Side lengths"},
        plate.is_circle() ?
          "m lies outside of the plate; expected less than its "
          "radius, " +
            number(0.5 * geometry->side_length(0)) + " m, from the centre" :
          "m lies outside of the plate; expected less than half of "
          "the sides, " +
            number(0.5 * geometry->side_length(0)) + ", " +
            number(0.5 * geometry->side_length(1)) + " m");
    if (scene.contact.has_patch() && scene.contact.patch_radius > to_edge)
      mistakes.refuse(
        {"Contact/Patch radius", "Plate/Side lengths", "Plate/Impact point"},
        "m reaches beyond the plate; expected at most the distance to the "
        "nearest edge, " +
          number(to_edge) + " m");
    if (plate.outline.shape != PlateOutline::rectangle &&
        scene.adaptivity.strategy == AdaptationStrategy::remeshing)
      mistakes.refuse(
        {"Adaptivity/Strategy", "Plate/Outline"},
        "makes meshes of rectangles only; expected another strategy for "
        "another outline, as hanging nodes");
  }
} // namespace PlateImpact
