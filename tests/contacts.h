#pragma once

#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/contact.h"
#include "plate_impact/contact/contact_bodies.h"
#include "plate_impact/contact/hertz_law.h"
#include "plate_impact/contact/line_law.h"
#include "plate_impact/plate/plate_section.h"

#include <memory>
#include <vector>

/// Laws and contacts of all kinds, for what every one of them has to do.
namespace PlateImpact
{
  // the paper's cylinder
  inline const double modulus = 2.1e11 / (2. * 0.91);

  inline const auto hertz_law     = std::make_shared<HertzLaw>(1.4e10);
  inline const auto make_line_law = [](const double constant) {
    const auto law =
      std::make_shared<LineLaw>(0.01, 0.0333335, modulus, constant);
    return std::make_shared<TangentBeyond>(law, law->largest_indentation);
  };
  inline const auto line_law = make_line_law(LineLaw::constant_of_half_space),
                    line_law_on_layer = make_line_law(-0.69);
  // the main scene's ball on steel of 355 MPa
  inline const double first_yield = [] {
    Parameters scene{};
    auto      &plate              = scene.plate;
    plate.thickness               = 0.008;
    plate.youngs_modulus          = 2.1e11;
    plate.poissons_ratio          = 0.3;
    plate.density                 = 7800.;
    plate.shear_correction_factor = 5. / 6.;
    plate.yield_strength          = 3.55e8;
    scene.impactor.radius         = 0.01;
    scene.impactor.youngs_modulus = plate.youngs_modulus;
    scene.impactor.poissons_ratio = plate.poissons_ratio;
    const ContactBodies bodies(scene, PlateSection(plate));
    return *bodies.yield_indentation;
  }();
  inline const auto yielding_law =
    std::make_shared<YieldingLaw>(1.5e10, first_yield, 0.5);

  inline const std::vector<std::shared_ptr<const ContactLaw>> laws =
    {hertz_law, line_law, line_law_on_layer, yielding_law};

  // in series with the layer of an 8 mm steel plate, and on it
  inline const Contact hertz(hertz_law), series(hertz_law, -3.3e-10),
    softer(hertz_law, 3.3e-10), line(line_law),
    line_on_layer(line_law_on_layer);

  inline const std::vector<const Contact *> elastic_contacts = {&hertz,
                                                                &line,
                                                                &series,
                                                                &softer,
                                                                &line_on_layer};

  inline const auto yang_sun = yang_sun_unloading(2e-5);
  inline const auto plastic  = plastic_unloading(yielding_law);

  /// Contacts that leave a dent, each in series with nothing, and with what
  /// is stiffer or softer.
  inline std::vector<Contact>
  denting_contacts()
  {
    const auto           soft = std::make_shared<HertzLaw>(8e8);
    std::vector<Contact> all;
    for (const double share : {0., -0.1, 0.1})
      {
        all.emplace_back(soft, share / soft->stiffness(6e-5), yang_sun);
        all.emplace_back(yielding_law,
                         share / yielding_law->stiffness(6e-5),
                         plastic);
      }
    return all;
  }
} // namespace PlateImpact
