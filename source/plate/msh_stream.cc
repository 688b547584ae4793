#include "plate_impact/plate/msh_stream.h"

#include "plate_impact/base/plate_file.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <type_traits>

namespace PlateImpact
{
  MshStream::MshStream(const std::string &path)
    : in(path, std::ios::binary)
  {}



  bool
  MshStream::next_section()
  {
    while (std::getline(in, name))
      {
        name.erase(name.find_last_not_of(" \t\r") + 1);
        if (!name.empty() && name[0] == '$')
          return true;
      }
    return false;
  }



  const std::string &
  MshStream::section() const
  {
    return name;
  }



  void
  MshStream::end_section()
  {
    if (const std::string found = word(); found != end_of_section())
      refuse("expected " + end_of_section() + ", not '" + found + "'");
  }



  void
  MshStream::skip_section()
  {
    const std::string end = end_of_section();
    for (std::string line; std::getline(in, line);)
      if (line.compare(0, end.size(), end) == 0)
        return;
    refuse_end();
  }



  template <typename Number>
  Number
  MshStream::next()
  {
    if (!is_binary)
      return text<Number>();
    char bytes[sizeof(Number)];
    if (!in.read(bytes, sizeof(bytes)))
      refuse_end();
    if (is_swapped)
      std::reverse(std::begin(bytes), std::end(bytes));
    Number number;
    std::memcpy(&number, bytes, sizeof(bytes));
    return number;
  }



  template <typename Number>
  Number
  MshStream::text()
  {
    const std::string found  = word();
    const char *const begin  = found.data() + (found[0] == '+' ? 1 : 0),
                      *end   = found.data() + found.size();
    Number number            = 0;
    const auto [last, error] = std::from_chars(begin, end, number);
    if (error != std::errc() || last != end)
      refuse(std::string("expected a ") +
             (std::is_integral_v<Number> ? "whole " : "") + "number, not '" +
             found + "'");
    return number;
  }



  std::string
  MshStream::rest_of_line()
  {
    std::string line;
    std::getline(in, line);
    return line;
  }



  void
  MshStream::refuse(const std::string &what)
  {
    std::string place;
    if (!is_binary)
      {
        in.clear();
        const std::streamoff end = in.tellg();
        in.seekg(0);
        unsigned int line = 1;
        for (std::streamoff at = 0; at < end; ++at)
          line += in.get() == '\n' ? 1 : 0;
        place = " in line " + std::to_string(line) + ",";
      }
    refuse_file("is damaged" + place + " in " + name + ": " + what);
  }



  std::string
  MshStream::end_of_section() const
  {
    return "$End" + name.substr(1);
  }



  void
  MshStream::refuse_end() const
  {
    refuse_file("is damaged: it ends within " + name);
  }



  std::string
  MshStream::word()
  {
    std::string found;
    if (!(in >> found))
      refuse_end();
    return found;
  }



  template double
  MshStream::next();
  template int
  MshStream::next();
  template std::uint64_t
  MshStream::next();
  template double
  MshStream::text();
  template int
  MshStream::text();
  template std::uint64_t
  MshStream::text();
} // namespace PlateImpact
