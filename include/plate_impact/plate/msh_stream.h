#ifndef plate_impact_plate_msh_stream_h
#define plate_impact_plate_msh_stream_h

#include <fstream>
#include <string>

namespace PlateImpact
{
  /// The numbers of a mesh of Gmsh, section by section: words, or bytes in a
  /// binary file. All members throw InputError at the first that is wrong, a
  /// sentence with its line that goes on from the name of the file.
  class MshStream
  {
  public:
    explicit MshStream(const std::string &path);

    /// Goes on to the next section.
    /// @return whether there is one
    bool
    next_section();

    /// With its `$`.
    const std::string &
    section() const;

    void
    end_section();

    void
    skip_section();

    /// @tparam Number  double, int or std::uint64_t
    template <typename Number>
    Number
    next();

    /// A number that is a word in a binary file as well.
    template <typename Number>
    Number
    text();

    std::string
    rest_of_line();

    [[noreturn]] void
    refuse(const std::string &what);

    bool is_binary = false, is_swapped = false;

  private:
    std::string
    end_of_section() const;
    [[noreturn]] void
    refuse_end() const;
    std::string
    word();

    std::ifstream in;
    std::string   name;
  };
} // namespace PlateImpact

#endif
