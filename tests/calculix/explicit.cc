// Ball and plate as elastic-plastic bodies, axisymmetric, by central
// differences.
//
//   explicit MODEL HISTORY FACE
//
// MODEL is a text file of impact.py; HISTORY gets a line for every output
// interval (time, mean contact force, mean velocity of the ball, displacement
// of the plate's centre, contact radius), FACE the final place of the plate's
// face (r, displacement). SI units: m, s, kg, N, Pa; forces are those of the
// whole circumference.
//
// Mass: row sums. Contact: at Gauss points of the ball's surface a pressure of
// `penalty` times the penetration of the plate's face in its present place, on
// both bodies: momentum is conserved. Steps: 0.9 of what the largest eigenvalue
// of an element and of the contact allow.

#include "element.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
  /// What impact.py writes.
  struct Model
  {
    std::vector<Point>              nodes;
    std::vector<std::array<int, 4>> quads;
    std::vector<int>                material_of;
    std::vector<Material>           materials;    // of plate and ball
    std::vector<int>                face;         // of the plate, from the axis
    std::vector<int>                ball_surface; // from the lowest point
    std::vector<int>                bed;    // nodes that stay at their height
    std::vector<int>                pushed; // nodes that move as told
    double                          penalty     = 0; // [Pa/m]
    double                          velocity    = 0; // of the ball, downwards
    double                          push_depth  = 0; // of `pushed` at mid-time
    double                          end_time    = 0;
    double                          output_step = 0;
  };

  Model
  read(const std::string &name)
  {
    std::ifstream in(name);
    if (!in)
      throw std::runtime_error("cannot read " + name);
    in.exceptions(std::ios::failbit | std::ios::badbit | std::ios::eofbit);
    Model       model;
    std::size_t n = 0;
    in >> n;
    model.nodes.resize(n);
    for (Point &node : model.nodes)
      in >> node.r >> node.z;
    in >> n;
    model.quads.resize(n);
    model.material_of.resize(n);
    for (std::size_t e = 0; e < n; ++e)
      {
        for (int &node : model.quads[e])
          in >> node;
        in >> model.material_of[e];
      }
    in >> n;
    model.materials.resize(n);
    for (Material &material : model.materials)
      {
        double E, nu;
        in >> E >> nu >> material.density >> material.yield_strength >>
          material.plastic_modulus;
        material.bulk  = E / (3 * (1 - 2 * nu));
        material.shear = E / (2 * (1 + nu));
      }
    for (std::vector<int> *list :
         {&model.face, &model.ball_surface, &model.bed, &model.pushed})
      {
        in >> n;
        list->resize(n);
        for (int &node : *list)
          in >> node;
      }
    in >> model.penalty >> model.velocity >> model.push_depth >>
      model.end_time >> model.output_step;
    return model;
  }

  class Simulation
  {
  public:
    explicit Simulation(const Model &model);

    void
    run(const std::string &history, const std::string &face);

  private:
    void
    internal_forces();

    /// Adds the contact forces; returns the force between the bodies [N].
    double
    contact_forces();

    void
    hold(const double time);

    double
    stable_step() const;

    double
    ball_velocity() const;

    const Model         &model;
    std::vector<Element> elements;
    std::vector<double>  mass;
    std::vector<Point>   displacement;
    std::vector<Point>   velocity; // at the middle of the step
    std::vector<Point>   force;
    std::vector<bool>    in_ball;
    double               step           = 0;
    double               contact_radius = 0;
  };

  Simulation::Simulation(const Model &model)
    : model(model)
    , mass(model.nodes.size())
    , displacement(model.nodes.size())
    , velocity(model.nodes.size())
    , force(model.nodes.size())
    , in_ball(model.nodes.size())
  {
    elements.reserve(model.quads.size());
    for (std::size_t e = 0; e < model.quads.size(); ++e)
      {
        elements.push_back(
          make_element(model.quads[e],
                       model.nodes,
                       model.materials.at(model.material_of[e])));
        for (int i = 0; i < 4; ++i)
          {
            mass[model.quads[e][i]] += elements.back().mass[i];
            in_ball[model.quads[e][i]] = model.material_of[e] == 1;
          }
      }
    for (std::size_t n = 0; n < mass.size(); ++n)
      if (in_ball[n])
        velocity[n].z = -model.velocity;
    step = stable_step();
  }

  double
  Simulation::stable_step() const
  {
    double body = 0;
    for (const Element &element : elements)
      body = std::max(body, largest_eigenvalue(element));
    // a node of the contact holds the pressure on the ring around it
    const auto over_mass = [&](const std::vector<int> &line) {
      double largest = 0;
      for (std::size_t i = 0; i + 1 < line.size(); ++i)
        {
          const Point &a = model.nodes[line[i]], &b = model.nodes[line[i + 1]];
          const double half =
            pi * (a.r + b.r) / 2 * std::hypot(b.r - a.r, b.z - a.z);
          largest = std::max(largest, 2 * half / mass[line[i + 1]]);
        }
      return largest;
    };
    const double contact =
      model.penalty * (over_mass(model.face) + over_mass(model.ball_surface));
    return 0.9 * 2 / std::sqrt(body + contact);
  }

  void
  Simulation::internal_forces()
  {
    std::fill(force.begin(), force.end(), Point());
    for (Element &element : elements)
      {
        std::array<Point, 4> increment;
        for (int i = 0; i < 4; ++i)
          {
            const Point &v = velocity[element.nodes[i]];
            increment[i]   = {step * v.r, step * v.z};
          }
        const auto forces = strain(element, increment);
        for (int i = 0; i < 4; ++i)
          {
            force[element.nodes[i]].r += forces[i].r;
            force[element.nodes[i]].z += forces[i].z;
          }
      }
  }

  double
  Simulation::contact_forces()
  {
    // three Gauss points on each side of the ball's surface
    constexpr double abscissa[3] = {0.11270166537925831,
                                    0.5,
                                    0.88729833462074169};
    constexpr double portion[3]  = {5. / 18, 8. / 18, 5. / 18};
    const auto       place       = [&](const int n) {
      return Point{model.nodes[n].r + displacement[n].r,
                   model.nodes[n].z + displacement[n].z};
    };
    const auto push = [&](const int n, const double f_r, const double f_z) {
      force[n].r += f_r;
      force[n].z += f_z;
    };

    double      total = 0;
    std::size_t side  = 0; // of the plate's face, below the point
    contact_radius    = 0;
    for (std::size_t k = 0; k + 1 < model.ball_surface.size(); ++k)
      {
        const int n_a = model.ball_surface[k], n_b = model.ball_surface[k + 1];
        const Point  a = place(n_a), b = place(n_b);
        const double length = std::hypot(b.r - a.r, b.z - a.z);
        bool         open   = true;
        for (int q = 0; q < 3; ++q)
          {
            const double t = abscissa[q];
            const Point  x = {(1 - t) * a.r + t * b.r, (1 - t) * a.z + t * b.z};
            while (side + 2 < model.face.size() &&
                   place(model.face[side + 1]).r < x.r)
              ++side;
            const int    n_c = model.face[side], n_d = model.face[side + 1];
            const Point  c = place(n_c), d = place(n_d);
            const double face   = std::hypot(d.r - c.r, d.z - c.z);
            const Point  normal = {-(d.z - c.z) / face, (d.r - c.r) / face};
            const double gap = (x.r - c.r) * normal.r + (x.z - c.z) * normal.z;
            if (gap > 3 * length)
              continue;
            open = false;
            if (gap >= 0)
              continue;
            const double s =
              ((x.r - c.r) * normal.z - (x.z - c.z) * normal.r) / face;
            const double f =
              -model.penalty * gap * 2 * pi * x.r * length * portion[q];
            push(n_a, (1 - t) * f * normal.r, (1 - t) * f * normal.z);
            push(n_b, t * f * normal.r, t * f * normal.z);
            push(n_c, -(1 - s) * f * normal.r, -(1 - s) * f * normal.z);
            push(n_d, -s * f * normal.r, -s * f * normal.z);
            total += f * normal.z;
            contact_radius = x.r;
          }
        if (open)
          break;
      }
    return total;
  }

  /// Overwrites the velocities that are given.
  void
  Simulation::hold(const double time)
  {
    for (std::size_t n = 0; n < mass.size(); ++n)
      if (model.nodes[n].r == 0)
        velocity[n].r = 0;
    for (const int n : model.bed)
      velocity[n].z = 0;
    const double rate = 2 * pi / model.end_time;
    for (const int n : model.pushed)
      velocity[n].z = -model.push_depth / 2 * rate * std::sin(rate * time);
  }

  double
  Simulation::ball_velocity() const
  {
    double momentum = 0, of_ball = 0;
    for (std::size_t n = 0; n < mass.size(); ++n)
      if (in_ball[n])
        {
          momentum += mass[n] * velocity[n].z;
          of_ball += mass[n];
        }
    return momentum / of_ball;
  }

  void
  Simulation::run(const std::string &history, const std::string &face)
  {
    std::ofstream out(history);
    out.precision(10);
    double time = 0, impulse = 0, since = 0, touched = 0;
    bool   first = true;
    while (time < model.end_time)
      {
        // displacement and force at `time`, velocity half a step earlier
        internal_forces();
        const double contact = contact_forces();
        if (contact > 0)
          touched = time;
        for (std::size_t n = 0; n < mass.size(); ++n)
          {
            const double scale = (first ? 0.5 : 1.0) * step / mass[n];
            velocity[n].r += scale * force[n].r;
            velocity[n].z += scale * force[n].z;
          }
        first = false;
        hold(time + step / 2);
        for (std::size_t n = 0; n < mass.size(); ++n)
          {
            displacement[n].r += step * velocity[n].r;
            displacement[n].z += step * velocity[n].z;
          }
        time += step;
        impulse += step * contact;
        if (time - since >= model.output_step)
          {
            const double v = ball_velocity();
            if (!std::isfinite(v))
              throw std::runtime_error("the computation is unstable");
            out << (time + since) / 2 << ' ' << impulse / (time - since) << ' '
                << v << ' ' << displacement[model.face[0]].z << ' '
                << contact_radius << '\n';
            impulse = 0;
            since   = time;
            // gone, and not only for the time of a ripple
            if (model.pushed.empty() && touched > 0 &&
                time - touched > 0.1 * touched && v > -0.5 * model.velocity)
              break;
          }
      }
    std::ofstream last(face);
    for (const int n : model.face)
      last << model.nodes[n].r << ' ' << displacement[n].z << '\n';
  }
} // namespace

int
main(int argc, char *argv[])
{
  if (argc != 4)
    {
      std::cerr << "explicit MODEL HISTORY FACE\n";
      return 2;
    }
  try
    {
      const Model model = read(argv[1]);
      Simulation(model).run(argv[2], argv[3]);
    }
  catch (const std::exception &error)
    {
      std::cerr << error.what() << '\n';
      return 1;
    }
  return 0;
}
