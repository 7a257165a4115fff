// Draws and letters both lines of action of a crossed pair, in any view.
//
//   A, E    ends of the leading line: tip of gear 2, tip of gear 1      C  pitch point of gear 1
//   A′ …    the same for the trailing line                    T_1, T_2  base tangent points
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "gearwright/base/vector.hpp"
#include "gearwright/figure/figure.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// A point of a line of action with its letter.
struct PathMark {
  const char* letter;
  double rho1;
  const char* style = "";  ///< style of its dot
};

/// The points A to E in this order, as far as they lie between A and `last`. If ε_α > 2, the end
/// of a period lies beyond the path, and B and D have no meaning.
std::vector<PathMark> path_marks(const Mesh<double>& mesh, double last);

/// A point to be named by a letter or by words (SVG markup) at the upper edge of a plot. If its y is
/// −∞, its line ends at the foot.
struct LetterAt {
  std::string letter;
  Vec2 at;
  std::string line_style = "leader", style = "letter halo";
};

/// Adds the letters to a figure whose axes contain the curves. The axes are extended by the room that
/// the letters need, above the plot and at both ends of the x axis.
void add_letters(Figure& figure, const std::vector<LetterAt>& letters);

/// ρ_1 of the points that a picture should contain: A, E, and C and the base tangent points unless
/// far from them.
std::vector<double> line_ends(const InvolutePair& pair);

enum class Lines { leading, both };

/// Adds the lines to a figure of a plane. `on` maps points of the housing to the plane. Each letter is on
/// the side away from the other line, or at a free position.
void add_lines_of_action(Figure& figure, const InvolutePair& pair,
                         const std::function<Vec2(const Point<Housing>&)>& on,
                         Lines lines = Lines::both);

/// The words for a caption (HTML).
std::string line_key();

}  // namespace gearwright
