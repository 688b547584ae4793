#include "plate_impact/output/run_in_words.h"

#include "plate_impact/base/text.h"
#include "plate_impact/contact/impactor.h"
#include "plate_impact/plate/plate_geometry.h"
#include "plate_impact/plate/plate_section.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace PlateImpact
{
  namespace
  {
    std::string
    place_in_words(const PlateParameters &plate)
    {
      const auto &point = plate.impact_point;
      if (point[0] == 0. && point[1] == 0.)
        return "the middle of";
      if (plate.is_circle())
        return about(std::hypot(point[0], point[1]), "m") +
          " from the middle of";
      const PrefixedUnit unit("m",
                              std::max(std::abs(point[0]), std::abs(point[1])));
      return number(unit(point[0])) + " and " + unit.text(point[1]) +
        ", along x and y, from the middle of";
    }



    template <typename Support>
    std::string
    supports_in_words(const std::vector<OnEdge<Support>> &supports)
    {
      if (supports.front().edge.empty())
        return word_for(supports.front().support) +
          (supports.back().support == supports.front().support ?
             "" :
             " (x edges) and " + word_for(supports.back().support) +
               " (y edges)");
      std::string text;
      for (const auto &[edge, support] : supports)
        text +=
          (text.empty() ? "" : ", ") + word_for(support) + " (" + edge + ")";
      return text;
    }



    std::string
    stretching_in_words(const PlateParameters &plate)
    {
      if (PlateSection(plate).stretching == Stretching::none)
        return "";
      return ", " + supports_in_words(plate.in_plane_supports) +
        " in its plane" +
        (plate.has_large_deflection ? ", with large deflections" : "");
    }
  } // namespace



  std::string
  scene_in_words(const Parameters &parameters)
  {
    const PlateParameters &plate = parameters.plate;
    const PrefixedUnit     side("m",
                            std::max(geometry_of(plate).side_lengths[0],
                                     geometry_of(plate).side_lengths[1])),
      thickness("m", plate.thickness);
    const std::string extent = plate.is_circle() ?
      "round plate of " + side.text(plate.side_lengths[0]) + " diameter, " :
      (plate.is_from_file() ? "plate (" +
           std::filesystem::path(plate.outline.file).filename().string() +
           ") of " :
                              "plate of ") +
        number(side(geometry_of(plate).side_lengths[0])) + " × " +
        side.text(geometry_of(plate).side_lengths[1]) + ", ";
    const std::string target = extent + thickness.text(plate.thickness) +
      " thick, " +
      (plate.is_laminate() ? "plies " + plate.layup.text + ", " : "") +
      supports_in_words(plate.supports) + stretching_in_words(plate);
    if (!parameters.has_impactor())
      return "A " + target + ". Nothing strikes it.";

    const ImpactorParameters &impactor = parameters.impactor;
    // masses in grams below one kilogram
    return "A " + word_for(impactor.shape) + " of radius " +
      number(impactor.radius, "m") + " and mass " +
      number(1e3 * make_impactor(impactor).mass, "g") + " strikes " +
      place_in_words(plate) + " a " + target + ", at " +
      number(impactor.velocity, "m/s") + ".";
  }



  std::string
  local_response_in_words(const Parameters &parameters)
  {
    const ContactParameters &contact = parameters.contact;
    if (contact.local_response == LocalResponse::layer)
      return "layer, as in three-dimensional elasticity";
    // the shear of a homogeneous plate has a factor of 5/6
    if (parameters.plate.shear_correction_factor > 10.)
      return "half-space, for a plate without shear deformation";
    std::string text = "half-space, in addition to the plate's shear: the "
                       "shortest waves count twice, so the force is too small";
    if (contact.law == ForceLaw::Sun)
      text += "; the law Sun has no other";
    else if (!contact.has_patch())
      text +=
        "; a " + word_for(contact.load_distribution) + " load has no other";
    return text;
  }



  std::string
  load_in_words(const Parameters &parameters)
  {
    const ContactParameters &contact = parameters.contact;
    const std::string        load    = word_for(contact.load_distribution);
    if (contact.load_is_singular())
      return load +
        (parameters.plate.shear_correction_factor > 10. ?
           "; the peak force converges, since the plate has no shear "
           "deformation" :
           ": the peak force does not converge under refinement");
    if (!contact.has_patch())
      return load;
    return load +
      (contact.load_has_length() ? " of half-width " : " of radius ") +
      number(contact.patch_radius, "m");
  }
} // namespace PlateImpact
