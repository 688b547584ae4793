#ifndef plate_impact_scene_scene_schema_h
#define plate_impact_scene_scene_schema_h

#include <deal.II/base/parameter_handler.h>

#include "plate_impact/scene/allowed.h"
#include "plate_impact/scene/scene_file.h"

#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace PlateImpact
{
  /// The entries of a scene, each bound to a variable: declared once, then set
  /// from assignments with every mistake collected, and printed through
  /// deal.II's ParameterHandler.
  class SceneSchema
  {
  public:
    /// The following declarations belong to this section.
    void
    begin_section(const std::string &name);

    /// Declares an entry with its default, and sets the variable to it.
    /// @param documentation  ends with the unit in brackets
    template <typename T>
    void
    declare(const std::string &entry,
            const std::string &default_value,
            const Allowed     &allowed,
            T                 &variable,
            const std::string &documentation);

    /// Sets an entry that the program has chosen a value for.
    void
    choose(const std::string &section,
           const std::string &entry,
           const std::string &value);

    /// Gives entries that the program has chosen a value for back what they
    /// were given.
    void
    take_back_choices();

    /// A sentence for each section of a scene that does not exist.
    std::vector<std::string>
    check_sections(const std::vector<Assignment> &openings) const;

    /// Sets the entries and returns a sentence for each that cannot be. Those
    /// of sections that a file opens and that do not exist are passed over: the
    /// section is the one mistake.
    std::vector<std::string>
    set(const std::vector<Assignment> &assignments);

    bool
    has_entry(const std::string &path) const;

    /// The sentence for an entry that does not exist.
    std::string
    unknown(const Assignment &assignment) const;

    /// What an entry may hold.
    const Allowed &
    allowed(const std::string &path) const;

    const std::string &
    default_value(const std::string &path) const;

    /// The unit that ends the meaning of an entry, empty without one.
    const std::string &
    unit(const std::string &path) const;

    /// Where an entry was set ("scene.prm:12"), or "default".
    std::string
    origin(const std::string &path) const;

    /// Whether a value that is not allowed was given for an entry.
    bool
    was_refused(const std::string &path) const;

    /// The value of an entry in words.
    std::string
    value(const std::string &path) const;

    /// Whether an entry differs from its default.
    bool
    is_changed(const std::string &path) const;

    /// The paths "Section/Entry" of a section.
    std::vector<std::string>
    entries_of(const std::string &section) const;

    void
    print(std::ostream &out, bool with_documentation) const;

  private:
    struct Entry
    {
      std::string name;
      std::string default_value;
      Allowed     allowed;
      std::string unit;
    };

    static std::string
    unit_of(const std::string &documentation);
    /// @return the mistake, empty when there is none
    std::string
    set(const Assignment &assignment);
    bool
    has_section(const std::string &name) const;

    dealii::ParameterHandler prm;
    /// by section, in the order of declaration
    std::vector<std::pair<std::string, std::vector<Entry>>> sections;
    /// by path, of the entries that were set
    std::map<std::string, std::string> origins;
    /// what chosen entries were given, by section and entry
    std::map<std::pair<std::string, std::string>, std::string> given;
    std::set<std::string>                                      refused;

    const Entry *
    find(const std::string &section, const std::string &entry) const;
    const Entry &
    at(const std::string &path) const;
  };


  template <typename T>
  void
  SceneSchema::declare(const std::string &entry,
                       const std::string &default_value,
                       const Allowed     &allowed,
                       T                 &variable,
                       const std::string &documentation)
  {
    sections.back().second.push_back(
      {entry, default_value, allowed, unit_of(documentation)});
    prm.enter_subsection(sections.back().first);
    prm.declare_entry(entry, default_value, allowed, documentation);
    prm.add_action(entry, [&variable](const std::string &text) {
      convert(text, variable);
    });
    prm.leave_subsection();
  }
} // namespace PlateImpact

#endif
