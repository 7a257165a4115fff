// Draws the figures of the theory pages, or checks that the existing files are up to date.
//
//   docs_figures DIR             writes DIR/00-notation.svg and so on
//   docs_figures --check DIR     compares; exits 1 and names every file that differs
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "docs/figures/figure.hpp"
#include "gearwright/base/output_file.hpp"

int main(int argc, char** argv) {
  using namespace gearwright;
  using namespace gearwright::figures;
  const bool check = argc == 3 && std::strcmp(argv[1], "--check") == 0;
  if (argc != 2 && !check) {
    std::fprintf(stderr, "usage: docs_figures [--check] DIR\n");
    return 2;
  }
  const std::string folder = argv[argc - 1];
  int stale = 0;
  for (const Drawing& figure :
       {notation_figure(), frames_figure(), mesh_triangle_figure(), generation_figure(),
        crossed_figure(), chord_figure(), few_teeth_figure(), arcs_figure(), contact_figure(),
        search_figure(), inspection_figure(), rating_figure(), load_figure(), drive_figure(),
        scatter_figure()}) {
    const std::string path = folder + "/" + std::string(figure.name()) + ".svg";
    const std::string text = figure.str();
    if (!check) {
      write_file(path, text);
      continue;
    }
    std::ifstream in(path, std::ios::binary);
    const std::string there{std::istreambuf_iterator<char>(in), {}};
    if (there == text) continue;
    ++stale;
    std::fprintf(stderr, "%s differs from the current drawing; `make figures` updates it\n",
                 path.c_str());
  }
  return stale == 0 ? 0 : 1;
}
