#include "contacts.h"
#include "plate_impact/base/exceptions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace PlateImpact
{
  namespace
  {
    TEST(ContactSolver, SolvesTheCollocatedEquation)
    {
      const ContactIntegration collocation = ForceIntegration::collocation;
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
      const ContactIntegration conserving = ForceIntegration::energy_conserving;
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
          for (const ContactIntegration integration :
               {ForceIntegration::energy_conserving,
                ForceIntegration::collocation})
            {
              const double phi =
                solve_contact(integration, contact, begin, free, compliance);
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
              ASSERT_LE(integration.force(contact, begin, end - bound),
                        phi + slack);
              ASSERT_GE(integration.force(contact, begin, end + bound),
                        phi - slack);
            }
        }
    }



    TEST(ContactSolver, NoContactIsExactlyNoForce)
    {
      const ContactIntegration collocation = ForceIntegration::collocation;
      const ContactIntegration conserving = ForceIntegration::energy_conserving;
      EXPECT_EQ(solve_contact(collocation, hertz, -1e-6, -1e-9, 1e-8), 0.);
      EXPECT_EQ(solve_contact(conserving, hertz, -1e-6, -1e-9, 1e-8), 0.);
      EXPECT_EQ(solve_contact(collocation, hertz, 1e-6, -1e-9, 1e-8), 0.);
    }



    TEST(ContactSolver, RefusesValuesThatAreNotFinite)
    {
      const ContactIntegration collocation = ForceIntegration::collocation;
      EXPECT_THROW(solve_contact(collocation,
                                 hertz,
                                 0.,
                                 std::numeric_limits<double>::quiet_NaN(),
                                 1e-8),
                   ComputationError);
    }
  } // namespace
} // namespace PlateImpact
