#pragma once

#include "plate_impact/base/text.h"
#include "plate_impact/contact/zener.h"
#include "plate_impact/scene/scene_reader.h"

#include <optional>
#include <string>
#include <vector>

namespace PlateImpact
{
  /// Parameters whose values are each allowed by themselves, checked against
  /// each other and with those that the program chooses.
  class SceneChecker : public Parameters
  {
  public:
    /// Checks entries against each other, with words in place of those not
    /// given that follow from others.
    /// @param reader  must outlive the checker, and gets the mistakes; what
    ///                involves an entry that is not known is not judged
    explicit SceneChecker(SceneReader &reader);

    /// Replaces zeros that mean "chosen by the program", and checks what is
    /// chosen; nothing where there are mistakes.
    void
    complete();

    /// Empty without an impactor or before complete().
    std::optional<ZenerImpact> expected;

  private:
    /// Adds a mistake in the value of the first entry, unless one of those
    /// involved is not known. Its place is that of the first of them which the
    /// scene sets.
    void
    refuse(const std::vector<std::string> &involved, const std::string &text)
    {
      Entry refused = entries.at(involved.front());
      for (const std::string &path : involved)
        {
          const Entry &entry = entries.at(path);
          if (!entry.is_known)
            return;
          if (refused.origin == "default")
            refused.origin = entry.origin;
        }
      reader.refuse(refused, text);
    }

    bool
    is_given(const std::string &path) const
    {
      return entries.at(path).origin != "default";
    }

    /// Fills an entry in.
    /// @param variable  of the parameters, that holds its value
    void
    choose(const std::string &path, double &variable, const double value)
    {
      variable                = value;
      entries.at(path).chosen = shortest(value);
    }

    /// Law, load and local response that fit the rest, where not given.
    void
    choose_contact();

    // checks of entries against each other, from read_plate() on in
    // plate_checker.cc

    void
    check_contact();
    void
    check_time();
    void
    check_mesh();
    /// Reads the plate from its file, unless it is there already, and refuses
    /// side lengths that tell another unit than the file's.
    /// @return whether there is no file to read, or it can be read
    bool
    read_plate();
    /// Lay-up or isotropic material; needs the law.
    void
    check_section();
    /// A ply in three dimensions.
    void
    check_ply();
    /// Outline, supports and what must lie within; needs the load's shape.
    void
    check_shape();
    /// The edges that an entry of supports names.
    template <typename Supports>
    void
    check_edges(const std::string &entry, const Supports &supports);

    // what is 0, in scene_completion.cc

    void
    complete_time();
    void
    complete_contact();
    /// Refuses a force that the local response of a layer does not hold.
    void
    complete_layer();
    void
    complete_mesh();

    SceneReader &reader;
    Entries     &entries = reader.entries;
  };
} // namespace PlateImpact
