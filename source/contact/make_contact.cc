#include "plate_impact/contact/make_contact.h"

#include "plate_impact/base/entries.h"
#include "plate_impact/contact/contact_bodies.h"
#include "plate_impact/contact/hertz_law.h"
#include "plate_impact/contact/line_law.h"
#include "plate_impact/plate/layer_response.h"
#include "plate_impact/plate/plate_section.h"

namespace PlateImpact
{
  namespace
  {
    /// @param layer_constant  empty on a half-space
    Contact
    make_sphere_contact(const Parameters            &parameters,
                        const std::optional<double> &layer_constant)
    {
      const ImpactorParameters &impactor = parameters.impactor;
      const PlateSection        section(parameters.plate);
      const ContactBodies       bodies(parameters, section);
      // of the compliance that the scene's law has for the plate
      const double k =
        hertz_coefficient(impactor.radius,
                          bodies.impactor_compliance,
                          parameters.contact.law == ForceLaw::Sun ?
                            1. / section.contact_modulus :
                            section.half_space_compliance);
      double compliance = 0.; // in series
      if (layer_constant)
        compliance = *layer_constant /
          (section.shear_modulus * parameters.plate.thickness);
      if (layer_constant && parameters.contact.finite_ball)
        {
          // that of the expected peak: it enters by its logarithm
          double radius = impactor.contact_radius;
          if (radius == 0.)
            {
              const ContactState peak = make_zener_impact(parameters).peak;
              radius = bodies.radius(peak.force, peak.indentation);
            }
          compliance += ball_compliance(impactor, radius);
        }
      std::shared_ptr<const ContactLaw> law = std::make_shared<HertzLaw>(k);
      std::shared_ptr<const Unloading>  unloading;
      if (parameters.contact.unloading == UnloadingLaw::Yang_Sun)
        unloading = yang_sun_unloading(parameters.contact.critical_indentation);
      else if (bodies.weaker)
        {
          const auto yielding =
            std::make_shared<YieldingLaw>(k,
                                          *bodies.yield_indentation,
                                          bodies.weaker->share_of_compliance);
          law       = yielding;
          unloading = plastic_unloading(yielding);
        }
      return Contact(law, compliance, unloading);
    }



    Contact
    make_line_contact(const Parameters            &parameters,
                      const std::optional<double> &layer_constant)
    {
      const ImpactorParameters &impactor = parameters.impactor;
      const PlateSection        section(parameters.plate);
      const ContactBodies       bodies(parameters, section);
      const double              half_length = 0.5 * impactor.length;
      double                    constant    = LineLaw::constant_of_half_space;
      // of a layer: the plate's side of the approach is F' (1 - nu) / (pi G)
      // (ln(h/a) + Lambda), the cylinder's F' (1 - nu^2) / (pi E) (2 ln(4r/a) -
      // 1), to its axis (Johnson, sec. 5.6), F' the force per length
      if (layer_constant)
        constant = bodies.modulus *
            (section.half_space_compliance *
               (std::log(parameters.plate.thickness) + *layer_constant) +
             bodies.impactor_compliance *
               (std::log(4. * impactor.radius) - 0.5)) -
          std::log(half_length);
      const auto law = std::make_shared<LineLaw>(impactor.radius,
                                                 half_length,
                                                 bodies.modulus,
                                                 constant);
      return Contact(
        std::make_shared<TangentBeyond>(law, law->largest_indentation));
    }



    struct LawRow
    {
      ForceLaw    choice;
      std::string word;
      Contact (*make)(const Parameters            &parameters,
                      const std::optional<double> &layer_constant);
    };

    const std::vector<LawRow> laws = {
      {ForceLaw::Sun, "Sun", make_sphere_contact},
      {ForceLaw::Hertz, "Hertz", make_sphere_contact},
      {ForceLaw::line, "line", make_line_contact}};

    const std::vector<Word<UnloadingLaw>> unloadings = {
      {UnloadingLaw::elastic, "elastic"},
      {UnloadingLaw::Yang_Sun, "Yang-Sun"}};

    const std::vector<Word<ForceIntegration>> integrations = {
      {ForceIntegration::energy_conserving, "energy conserving"},
      {ForceIntegration::collocation, "collocation"}};
  } // namespace



  template <>
  const std::vector<Word<ForceLaw>> Choices<ForceLaw>::words = words_of(laws);



  Contact
  make_contact(const Parameters &parameters)
  {
    const ContactParameters &contact = parameters.contact;
    if (contact.local_response == LocalResponse::half_space)
      return make_contact(parameters, /*layer_constant=*/{});
    const PlateParameters &plate = parameters.plate;
    const LayerResponse layer(PlateSection(plate), contact.load_distribution);
    const double        radius = contact.patch_radius / plate.thickness;
    return make_contact(parameters,
                        contact.law == ForceLaw::line ?
                          layer.line_constant(radius) :
                          layer.sphere_constant(radius));
  }



  Contact
  make_contact(const Parameters            &parameters,
               const std::optional<double> &layer_constant)
  {
    return row_of(parameters.contact.law, laws)
      .make(parameters, layer_constant);
  }



  void
  ImpactorParameters::declare_entries(Entries &entries)
  {
    const auto positive = number_above(0);
    const auto entry    = entries.section("Impactor");
    entry("Shape", "sphere", one_of<ImpactorShape>(), shape)
      .means("Cylinder: barrelled, with its axis along x.");
    entry("Radius", "0.01", positive, radius).means("[m]");
    entry("Length", "0.066667", positive, length)
      .means("Contact length 2l of a cylinder. [m]");
    entry("Mass", "0", number_from(0), mass)
      .means("0: from the density and the volume of the shape. [kg]");
    entry("Density", "7800", positive, density).means("[kg/m^3]");
    entry("Young's modulus", "2.1e11", positive, youngs_modulus).means("[Pa]");
    entry("Poisson's ratio", "0.3", number_between(-1, 0.5), poissons_ratio)
      .means("[-]");
    entry("Yield strength", "0", number_from(0), yield_strength)
      .means("As Plate/Yield strength. [Pa]");
    entry("Velocity", "1.0", positive, velocity)
      .means("Towards the plate. [m/s]");
  }



  void
  ContactParameters::declare_entries(Entries &entries)
  {
    const auto entry = entries.section("Contact");
    entry("Law", "Hertz", one_of<ForceLaw>(), law)
      .means("Hertz: F = k alpha^1.5 with the compliance (1 - nu^2)/E of both "
             "bodies, for a laminate with that of a half-space of its plies. "
             "Sun: the same with the compliance 1/E of the plate (the paper's "
             "eq. 17), or 1/E_2 for a laminate. line: line contact of a "
             "cylinder, the default for one; with Local response = half-space "
             "the paper's eq. 32.");
    entry("Local response", "layer", one_of<LocalResponse>(), local_response)
      .means("Local compliance of the plate under the contact, in addition to "
             "bending and shear. layer: that of an elastic layer as thick as "
             "the plate. half-space: that of Hertz's law, as usual and in the "
             "paper; it counts the shortest waves twice, so the force is too "
             "small. It is the default for the law Sun and for point and line "
             "loads.");
    entry("Finite ball", "true", truth(), finite_ball)
      .means("true: a sphere has the compliance of an elastic ball held by its "
             "inertia; false: that of Hertz's half-space. It has an effect "
             "with Local response = layer only.");
    entry("Unloading", "elastic", one_of(unloadings), unloading)
      .means("elastic: along the loading curve; after yielding, elastically "
             "down to the dent. Yang-Sun: along a steeper curve down to a "
             "dent, with another curve for reloading, as measured on "
             "laminates; for spheres only.");
    entry("Critical indentation", "8e-5", number_above(0), critical_indentation)
      .means("Indentation above which Yang-Sun leaves a dent; 8e-5 for "
             "graphite/epoxy, 1.65e-4 for glass/epoxy. [m]");
    entry("Load distribution",
          "Hertz disc",
          one_of<LoadShape>(),
          load_distribution)
      .means("How the contact force is distributed over the plate; the default "
             "for a cylinder is strip. The plate displacement in the contact "
             "law is averaged with the same weights. With 'point' the peak "
             "force does not converge under refinement: it drops with every "
             "halving of the cells.");
    entry("Patch radius", "0", number_from(0), patch_radius)
      .means("Radius of the disc or half-width of the strip. 0 for a layer: "
             "the radius for which plate theory and layer respond alike to "
             "long waves. 0 for a half-space: the Hertz contact radius at the "
             "peak force of Zener's equation, rounded in steps of 1.1 %. [m]");
    entry("Integration", "energy conserving", one_of(integrations), integration)
      .means("energy conserving: the mean force of the law over the step. "
             "collocation: the force at the end of the step, as in the paper; "
             "it gains energy when the step is coarse.");
  }
} // namespace PlateImpact
