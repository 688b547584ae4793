#include "contacts.h"

#include <gtest/gtest.h>

#include <cmath>

namespace PlateImpact
{
  namespace
  {
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
  } // namespace
} // namespace PlateImpact
