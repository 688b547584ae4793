#include "plate_impact/base/exceptions.h"
#include "plate_impact/base/parameters.h"
#include "plate_impact/contact/ball_compliance.h"
#include "plate_impact/contact/contact.h"
#include "plate_impact/contact/contact_bodies.h"
#include "plate_impact/contact/contact_solver.h"
#include "plate_impact/contact/hertz_law.h"
#include "plate_impact/contact/line_law.h"
#include "plate_impact/contact/yang_sun_unloading.h"
#include "plate_impact/contact/yielding_law.h"
#include "plate_impact/contact/zener.h"
#include "plate_impact/plate/plate_section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace PlateImpact
{
  namespace
  {
    // the paper's cylinder
    const double modulus = 2.1e11 / (2. * 0.91);

    const auto hertz_law = std::make_shared<HertzLaw>(1.4e10);
    const auto line_law  = std::make_shared<LineLaw>(0.01, 0.0333335, modulus);
    const auto line_law_on_layer =
      std::make_shared<LineLaw>(0.01, 0.0333335, modulus, -0.69);
    // the main scene's ball on steel of 355 MPa
    const double first_yield =
      yield_indentation(0.01, modulus, 3.55e8, /*poissons_ratio=*/0.3);
    const auto yielding_law =
      std::make_shared<YieldingLaw>(1.5e10, first_yield, 0.5);

    const std::vector<std::shared_ptr<const ContactLaw>> laws =
      {hertz_law, line_law, line_law_on_layer, yielding_law};

    // in series with the layer of an 8 mm steel plate, and on it
    const Contact hertz(hertz_law), series(hertz_law, -3.3e-10),
      softer(hertz_law, 3.3e-10), line(line_law),
      line_on_layer(line_law_on_layer);

    const std::vector<const Contact *> elastic_contacts = {&hertz,
                                                           &line,
                                                           &series,
                                                           &softer,
                                                           &line_on_layer};

    const auto yang_sun = std::make_shared<YangSunUnloading>(2e-5);
    const auto plastic  = std::make_shared<PlasticUnloading>(yielding_law);

    /// Contacts that leave a dent, each in series with nothing, and with what
    /// is stiffer or softer.
    std::vector<Contact>
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



    TEST(ContactLaw, HertzForceIsThePowerThreeHalves)
    {
      EXPECT_DOUBLE_EQ(hertz_law->force(1e-6), 1.4e10 * 1e-9);
      EXPECT_EQ(hertz_law->force(0.), 0.);
      EXPECT_EQ(hertz_law->force(-1e-6), 0.);
      EXPECT_EQ(hertz_law->stiffness(-1e-6), 0.);
      EXPECT_EQ(hertz_law->potential(-1e-6), 0.);
    }



    TEST(ContactLaw, StiffnessIsTheDerivativeOfForceAndForceThatOfPotential)
    {
      for (const auto &law : laws)
        for (const double alpha : {1e-9, 1e-6, 1e-3, 1.})
          {
            const double h = 1e-4 * alpha;
            EXPECT_NEAR((law->force(alpha + h) - law->force(alpha - h)) /
                          (2 * h) / law->stiffness(alpha),
                        1.,
                        1e-7)
              << alpha;
            EXPECT_NEAR((law->potential(alpha + h) -
                         law->potential(alpha - h)) /
                          (2 * h) / law->force(alpha),
                        1.,
                        1e-7)
              << alpha;
          }
    }



    TEST(ContactLaw, ForceAndStiffnessNeverDecrease)
    {
      for (const auto &law : laws)
        {
          double last = 0., last_stiffness = 0.;
          EXPECT_EQ(law->force(0.), 0.);
          EXPECT_EQ(law->force(-1.), 0.);
          EXPECT_EQ(law->stiffness(-1.), 0.);
          EXPECT_EQ(law->potential(-1.), 0.);
          for (double alpha = 1e-320; alpha < 1e3; alpha *= 1.7)
            {
              EXPECT_GE(law->force(alpha), last) << alpha;
              EXPECT_GE(law->stiffness(alpha), 0.98 * last_stiffness) << alpha;
              last           = law->force(alpha);
              last_stiffness = law->stiffness(alpha);
            }
        }
    }



    TEST(ContactLaw, IndentationInvertsForce)
    {
      for (const auto &law : laws)
        {
          for (const double alpha : {1e-30, 1e-12, 1e-6, 1e-1, 10.})
            EXPECT_NEAR(law->indentation(law->force(alpha)) / alpha, 1., 1e-13)
              << alpha;
          EXPECT_EQ(law->indentation(-1.), 0.);
        }
    }



    TEST(ContactLaw, MeansTimesDistanceAreChanges)
    {
      for (const auto &law : laws)
        for (const double a : {-2e-6, 0., 1e-9, 1e-6, 3e-6})
          for (const double b : {-1e-6, 0., 2e-9, 1.5e-6, 1.03e-6, 2.9e-6})
            if (a != b)
              {
                EXPECT_NEAR(law->mean_force(a, b) * (b - a),
                            law->potential(b) - law->potential(a),
                            1e-14 * (law->potential(a) + law->potential(b)));
                EXPECT_NEAR(law->mean_stiffness(a, b) * (b - a),
                            law->force(b) - law->force(a),
                            1e-14 * (law->force(a) + law->force(b)));
              }
    }



    TEST(ContactLaw, MeansDoNotCancelForCloseIndentations)
    {
      for (const auto &law : laws)
        for (const double a : {1e-6, 1e-4})
          {
            EXPECT_NEAR(law->mean_force(a, a) / law->force(a), 1., 1e-14);
            const double beside = a * (1. + 1e-12);
            EXPECT_NEAR(law->mean_force(a, beside) / law->force(a), 1., 2e-12);
            EXPECT_NEAR(law->mean_stiffness(a, beside) / law->stiffness(a),
                        1.,
                        2e-12);
          }
    }



    TEST(ContactLaw, YieldingBeginsAtThePressureOfGreen)
    {
      // Hertz's largest pressure 2 E* / pi (alpha / r)^{1/2} is C Y there
      const double pressure =
        2. * modulus / std::acos(-1.) * std::sqrt(first_yield / 0.01);
      EXPECT_NEAR(pressure / (1.295 * std::exp(0.736 * 0.3) * 3.55e8),
                  1.,
                  1e-12);
      EXPECT_EQ(yielding_law->force(0.5 * first_yield),
                HertzLaw(1.5e10).force(0.5 * first_yield));
      EXPECT_LT(yielding_law->force(20. * first_yield),
                0.8 * HertzLaw(1.5e10).force(20. * first_yield));
    }



    TEST(Contact, ApproachAndItsInverse)
    {
      std::vector<const Contact *> contacts = elastic_contacts;
      std::vector<Contact>         denting  = denting_contacts();
      for (Contact &contact : denting)
        {
          contact.follow(5e-5);
          contacts.push_back(&contact);
        }
      for (const Contact *contact : contacts)
        for (const double alpha : {-1e-6, 1e-30, 1e-12, 1e-6, 1e-4, 1e-1, 10.})
          {
            EXPECT_NEAR(contact->indentation_under(contact->approach(alpha)) /
                          alpha,
                        1.,
                        1e-13)
              << alpha;
            const double h = 1e-4 * std::abs(alpha);
            EXPECT_NEAR((contact->approach(alpha + h) -
                         contact->approach(alpha - h)) /
                          (2 * h) / contact->approach_derivative(alpha),
                        1.,
                        1e-7)
              << alpha;
            EXPECT_GT(contact->approach_derivative(alpha), 0.);
          }
    }



    TEST(Contact, ElasticWorkIsTheChangeOfTheStoredEnergy)
    {
      for (const Contact *contact : elastic_contacts)
        for (const double a : {-2e-6, 0., 1e-9, 1e-6, 3e-6})
          for (const double b : {-1e-6, 0., 2e-9, 1.5e-6, 1.03e-6, 2.9e-6})
            if (a != b)
              {
                EXPECT_NEAR(
                  contact->mean_force(a, b) *
                    (contact->approach(b) - contact->approach(a)),
                  contact->stored_energy(b) - contact->stored_energy(a),
                  1e-14 *
                    (contact->stored_energy(a) + contact->stored_energy(b)));
                EXPECT_EQ(contact->dissipated_energy(b), 0.);
              }
    }



    // up, down in contact, up again, apart, up beyond the largest
    const std::vector<double> path = {1e-5,
                                      3e-5,
                                      5e-5,
                                      4.99999e-5,
                                      4e-5,
                                      4.5e-5,
                                      2e-5,
                                      -1e-6,
                                      3e-5,
                                      2.5e-5,
                                      6e-5,
                                      -1e-6};



    TEST(Contact, IsContinuousAndNeverDecreasesWithADent)
    {
      for (Contact contact : denting_contacts())
        {
          const double most = contact.first_loading().force(7e-5);
          for (const double alpha : path)
            {
              double before = contact.force(-1e-6);
              EXPECT_EQ(before, 0.);
              for (double a = 0.; a < 7e-5; a += 1e-8)
                {
                  const double F = contact.force(a);
                  EXPECT_GE(F, before);
                  EXPECT_LT(F - before, 0.01 * most); // no jump
                  EXPECT_NEAR(contact.indentation_under(contact.approach(a)),
                              a,
                              1e-17);
                  before = F;
                }
              contact.follow(alpha);
            }
          EXPECT_NEAR(contact.force(6e-5) / contact.first_loading().force(6e-5),
                      1.,
                      1e-12);
          EXPECT_GT(contact.dent(), 0.);
        }
    }



    TEST(Contact, WorkIsStoredOrDissipated)
    {
      for (Contact contact : denting_contacts())
        {
          const double most = contact.first_loading().potential(6e-5);
          double       work = 0., before = 0., dissipated = 0.;
          for (const double alpha : path)
            {
              work += contact.mean_force(before, alpha) *
                (contact.approach(alpha) - contact.approach(before));
              EXPECT_NEAR(contact.stored_energy(alpha) +
                            contact.dissipated_energy(alpha),
                          work,
                          1e-14 * most);
              // heat does not come back
              EXPECT_GE(contact.dissipated_energy(alpha),
                        dissipated - 1e-14 * most);
              dissipated = contact.dissipated_energy(alpha);
              before     = alpha;
              contact.follow(alpha);
            }
          EXPECT_EQ(contact.stored_energy(-1e-6), 0.);
          // the mean force is that of a sum over small parts, across branches
          contact.follow(4e-5);
          double    sum = 0.;
          const int n   = 1000000;
          for (int i = 0; i < n; ++i)
            {
              const double alpha = 7e-5 * (i + 0.5) / n;
              sum += contact.force(alpha) * contact.approach_derivative(alpha) *
                7e-5 / n;
            }
          EXPECT_NEAR(contact.mean_force(0., 7e-5) * contact.approach(7e-5) /
                        sum,
                      1.,
                      1e-6);
        }
    }



    TEST(Contact, DentsOfYangAndSun)
    {
      Contact contact(std::make_shared<HertzLaw>(8e8), 0., yang_sun);
      contact.follow(6e-5);
      EXPECT_NEAR(contact.dent(),
                  6e-5 * (1. - std::pow(2e-5 / 6e-5, 0.4)),
                  1e-18);
      EXPECT_NEAR(contact.force(0.5 * (contact.dent() + 6e-5)) /
                    contact.force(6e-5),
                  std::pow(0.5, 2.5),
                  1e-12);
      contact.follow(-1e-6); // reloaded by another power
      EXPECT_NEAR(contact.force(0.5 * (contact.dent() + 6e-5)) /
                    contact.force(6e-5),
                  std::pow(0.5, 1.5),
                  1e-12);
    }



    TEST(BallCompliance, IsThatOfTheSphereUnderACapOfPressure)
    {
      // -C G R with the pressure of Hertz on a spherical cap, as the flat
      // disc up to (a / R)^2
      const auto c = [](const double nu, const double ratio) {
        return -ball_compliance(0.01, 8e10, nu, 0.01 * ratio) * 8e10 * 0.01;
      };
      EXPECT_NEAR(c(0.22, 0.02), 0.0809, 0.0809 * 0.01);
      EXPECT_NEAR(c(0.3, 0.02), 0.1081, 0.1081 * 0.01);
      EXPECT_NEAR(c(0.45, 0.02), 0.1156, 0.1156 * 0.01);
      EXPECT_NEAR(c(0.3, 0.05), 0.1194, 0.1194 * 0.015);
      EXPECT_NEAR(c(0.3, 0.1), 0.1279, 0.1279 * 0.03);
    }



    TEST(ContactLaw, LineLawIsThatOfTheReferenceHistory)
    {
      // eq. 32 with the force per length: 9095.3 N of the reference
      const double F = 9095.3, l = 0.0333335;
      const double a =
        std::sqrt(4. * F / (2. * l) * 0.01 / (3.14159265358979 * modulus));
      EXPECT_NEAR(line_law->indentation(F) * 3.14159265358979 * l * modulus / F,
                  1.886 + std::log(l / a),
                  1e-12);
    }



    TEST(ContactLaw, CoefficientsOfTheTwoLawsOfTheSphere)
    {
      // steel on steel: impact_cases.json gives K of both laws
      const double E = 2.1e11, c = (1. - 0.09) / E;
      EXPECT_NEAR(hertz_coefficient(0.01, c, 1. / E), 14659685863.874344, 1.);
      EXPECT_NEAR(hertz_coefficient(0.01, c, c), 15384615384.615383, 1.);
    }



    TEST(ContactSolver, SolvesTheCollocatedEquation)
    {
      const CollocatedContact collocation;
      for (const double compliance : {1e-20, 1e-12, 1e-8, 1e-4, 1e4})
        for (const double free : {1e-12, 1e-6, 1e-2})
          {
            const double phi =
              solve_contact(collocation, hertz, 0., free, compliance);
            const double alpha = hertz_law->indentation(phi);
            EXPECT_NEAR((alpha + compliance * phi) / free, 1., 1e-13)
              << compliance << ' ' << free;
          }
    }



    TEST(ContactSolver, SolvesTheEnergyConservingEquation)
    {
      const EnergyConservingContact conserving;
      for (const double compliance : {1e-20, 1e-12, 1e-8, 1e-4, 1e4})
        for (const double begin : {-1e-6, 0., 1e-9, 1e-6, 1e-3})
          for (const double free : {-1e-3, 1e-12, 1e-6, 1e-2})
            {
              const double phi =
                solve_contact(conserving, hertz, begin, free, compliance);
              const double end = free - compliance * phi;
              EXPECT_GE(phi, 0.);
              // where the compliance dominates, round-off of `end` decides
              const double error = std::abs(hertz.mean_force(begin, end) - phi);
              EXPECT_LE(error,
                        1e-13 * phi +
                          hertz.stiffness(std::max(begin, end)) * 1e-14 *
                            (std::abs(free) + std::abs(begin)))
                << compliance << ' ' << begin << ' ' << free;
            }
    }



    TEST(ContactSolver, SolvesStepsOfEveryKind)
    {
      // indentations of both signs and compliances over many orders
      const EnergyConservingContact          conserving;
      const CollocatedContact                collocation;
      std::mt19937                           generator(1);
      std::uniform_real_distribution<double> exponent(0., 6.), sign(-1., 1.);
      const auto                             indentation = [&] {
        return std::copysign(1e-4 * std::pow(10., -exponent(generator)),
                             sign(generator));
      };
      std::vector<const Contact *> contacts = elastic_contacts;
      std::vector<Contact>         denting  = denting_contacts();
      for (Contact &contact : denting)
        {
          contact.follow(5e-5);
          contacts.push_back(&contact);
        }
      for (unsigned int i = 0; i < 200000; ++i)
        {
          const Contact &contact = *contacts[i % contacts.size()];
          const double   begin = indentation(), free = indentation(),
                       compliance = 1e-5 * std::pow(10., -exponent(generator));
          for (const ContactIntegration *integration :
               std::initializer_list<const ContactIntegration *>{&conserving,
                                                                 &collocation})
            {
              const double phi =
                solve_contact(*integration, contact, begin, free, compliance);
              ASSERT_GE(phi, 0.);
              const double end =
                contact.indentation_under(free - compliance * phi);
              const double bound = 1e-14 *
                (std::abs(free) + std::abs(end) + compliance * phi) /
                contact.approach_derivative(end);
              // the force at an end moved by round-off on either side; beside
              // a dent round-off is that of the whole indentation
              const double slope = contact.stiffness(end);
              const double slack = 1e-12 * phi +
                1e-15 * std::abs(end) * slope * (1. + compliance * slope);
              ASSERT_LE(integration->force(contact, begin, end - bound),
                        phi + slack);
              ASSERT_GE(integration->force(contact, begin, end + bound),
                        phi - slack);
            }
        }
    }



    TEST(ContactSolver, NoContactIsExactlyNoForce)
    {
      const CollocatedContact       collocation;
      const EnergyConservingContact conserving;
      EXPECT_EQ(solve_contact(collocation, hertz, -1e-6, -1e-9, 1e-8), 0.);
      EXPECT_EQ(solve_contact(conserving, hertz, -1e-6, -1e-9, 1e-8), 0.);
      EXPECT_EQ(solve_contact(collocation, hertz, 1e-6, -1e-9, 1e-8), 0.);
    }



    TEST(ContactSolver, RefusesValuesThatAreNotFinite)
    {
      const CollocatedContact collocation;
      EXPECT_THROW(solve_contact(collocation,
                                 hertz,
                                 0.,
                                 std::numeric_limits<double>::quiet_NaN(),
                                 1e-8),
                   ComputationError);
    }
  } // namespace
} // namespace PlateImpact
