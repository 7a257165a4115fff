// Draws both lines of action of a crossed pair with the letters of their points, in any view.
//
//   A, E    ends of the leading line: tip of gear 2, tip of gear 1      C  pitch point of gear 1
//   A′, E′  ends of the trailing line                         T_1, T_2  base tangent points
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "gearwright/base/vector.hpp"
#include "gearwright/figure/figure.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

struct PathMark {
  const char* letter;
  double rho1;
  const char* style = "";  ///< style of the dot
};

/// Returns the points A to E that lie between A and `last`, in alphabetical order. B = E − step is
/// omitted if the path is shorter than one step, because B would lie before A.
std::vector<PathMark> path_marks(const Mesh<double>& mesh, double last);

/// A point whose letter or words (SVG markup) are written at the upper border of a plot, with a
/// line to the point. If y is −∞, the line ends at the lower border.
struct LetterAt {
  std::string letter;
  Vec2 at;
  std::string line_style = "leader", style = "letter halo";
};

/// Adds the letters to a figure whose axes already contain the curves. The axes are extended so
/// that there is room for the letters at the top and at both ends of the x axis.
void add_letters(Figure& figure, const std::vector<LetterAt>& letters);

/// Returns ρ_1 of the points that a picture should contain: A, E, C and the base tangent points. C
/// and the base tangent points are omitted if they are far from A and E.
std::vector<double> line_ends(const CrossedPair& pair);

enum class Lines { leading, both };

/// Draws the lines of action in a figure of a plane. `on` maps points of the housing to the
/// plane. Each letter is on the side of its line that faces away from the other line, or at
/// another position if it would overlap another label there.
void add_lines_of_action(Figure& figure, const CrossedPair& pair,
                         const std::function<Vec2(const Point<Housing>&)>& on,
                         Lines lines = Lines::both);

/// Returns an explanation of the letters and of the line styles, as HTML for a caption.
std::string line_key();

}  // namespace gearwright
