#include <string>

#include "cli/commands.hpp"
#include "cli/terminal/exit_code.hpp"
#include "cli/terminal/output.hpp"
#include "cli/terminal/progress.hpp"
#include "commands/plot_pictures.hpp"

namespace dumbbell::cli {
namespace {

constexpr const char* plot_footer =
    "Exit codes: 0 done; 1 internal error; 2 wrong usage, or a file that is not verified.";

constexpr const char* plot_description =
    R"(Draw pictures (SVG) from certificates: text as text, for light and dark pages.

Each certificate is verified first. The same certificate gives the same bytes.

Examples:
  dumbbell plot staircase certificates/stairs-1-100.dbc --out stairs.svg
  dumbbell plot orbit 100 --out orbit.svg
  dumbbell plot phase falling.dbc --out phase.svg
  dumbbell plot body certificates/plane.dbc.gz --out bodies.svg)";

constexpr const char* staircase_picture_description =
    R"(The proved maximum N(q) of the dumbbell, and the gaps in which it is one of two values.

The source paper's bound is drawn, too.

Example:
  dumbbell certify 1:100 --out stairs.dbc
  dumbbell plot staircase stairs.dbc --out stairs.svg)";

constexpr const char* orbit_picture_description =
    R"(An orbit with the greatest number of collisions, and the dumbbell at each of them.

It is the witness, every collision enclosed, in the plane of the rod's angle and the height, above the floor as the
point sees it. Of many collisions only some are drawn; the caption says which.

A mass ratio is proved on the spot. For a certificate over a range, --ratio chooses one.

Examples:
  dumbbell plot orbit 100 --out orbit.svg
  dumbbell plot orbit certificates/stairs-1-100.dbc --ratio 50 --out orbit.svg)";

constexpr const char* phase_picture_description =
    R"(Initial conditions, coloured by their certified number of collisions.

They are those of a certificate by dumbbell trace --subdivide. Two of phi, phidot, y, ydot and the mass ratio must be
intervals, the others numbers. Boxes of equal count are united exactly; what is not decided is hatched, never hidden.

Example:
  dumbbell trace 10 --phi 0:6.28 --phidot 1 --y 2 --ydot=-2:1 --subdivide --out falling.dbc
  dumbbell plot phase falling.dbc --out phase.svg)";

constexpr const char* body_picture_description =
    R"(The plane of all rigid bodies, and how often each can hit the floor.

Cells of one proved number are united and have its colour. The steps are the cells between: orange where one more
collision fits into the corner, dark where an orbit gets longer. Hatched: not decided. The massless rods (Q rho = 1),
rods of growing mass, the ring, the uniform rod and the coin are marked. Bodies move in a plane; proofs/body.md says
what rho and Q are.

Example:
  dumbbell certify --rho 1/100:1 --inertia 1:100 --decided 0.99 --out plane.dbc
  dumbbell plot body plane.dbc --out bodies.svg)";

constexpr std::array<Option, 2> from_file(std::string_view text) {
    return {argument("FILE", text).required(),
            Option{"--out", "FILE", "the SVG file to write; -: the standard output"}
                .checked(fault_of_name<Content::picture>)
                .required()};
}

template <std::string (*draw)(const Given&, Observer&)>
int run_plot(const Given& given) {
    const Output out(given.text("--out"), given.words("FILE"));
    Progress progress("", Verbosity::normal, "reading");
    out.commit(draw(given, progress));
    return exit_done;
}

constexpr std::array staircase_picture_options =
    from_file("certificate over a range of mass ratios (-: the standard input)");
constexpr std::array orbit_picture_options =
    joined(from_file("mass ratio, or certificate (-: the standard input)"),
           std::array{Option{"--ratio", "RATIO", "the mass ratio to draw, of a certificate over a range"}});
constexpr std::array phase_picture_options =
    from_file("certificate about initial conditions (-: the standard input)");

constexpr std::array body_picture_options =
    from_file("certificate about a rectangle of bodies (-: the standard input)");

constexpr Command picture(std::string_view name, std::string_view text, std::span<const Option> options,
                          int (*run)(const Given&)) {
    return {name, first_group, text, inherited, options, run};
}

constexpr Command staircase_picture =
    picture("staircase", staircase_picture_description, staircase_picture_options, run_plot<draw_staircase>);
constexpr Command orbit_picture =
    picture("orbit", orbit_picture_description, orbit_picture_options, run_plot<draw_orbit>);
constexpr Command phase_picture =
    picture("phase", phase_picture_description, phase_picture_options, run_plot<draw_phase>);
constexpr Command body_picture =
    picture("body", body_picture_description, body_picture_options, run_plot<draw_bodies>);
constexpr std::array pictures{&staircase_picture, &orbit_picture, &phase_picture, &body_picture};

}  // namespace

constinit const Command plot_command{"plot", more_group, plot_description, plot_footer,
                                     {},     nullptr,    pictures};

}  // namespace dumbbell::cli
