#include "gearwright/report/turning.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "gearwright/base/contract.hpp"
#include "gearwright/report/html_text.hpp"

namespace gearwright {

namespace {

constexpr int kSteps = 120;  // of the slider, and of an arrow key, per pitch

constexpr std::string_view kScript = R"js(
(function () {
  'use strict';
  var secondsPerPitch = 3;
  function list(nodes) { return Array.prototype.slice.call(nodes); }
  list(document.querySelectorAll('.turn')).forEach(function (control) {
    var scope = control.parentNode;
    while (scope && !(scope.classList && scope.classList.contains('figures'))) scope = scope.parentNode;
    if (!scope) return;
    function number(node, name) { return parseFloat(node.getAttribute(name)); }
    var gears = list(scope.querySelectorAll('[data-turn]')).map(function (node) {
      return {node: node, at: node.getAttribute('transform'), turn: number(node, 'data-turn')};
    });
    var touches = list(scope.querySelectorAll('[data-tooth]')).map(function (node) {
      return {node: node, tooth: number(node, 'data-tooth'), from: number(node, 'data-from'),
              to: number(node, 'data-to'), dx: number(node, 'data-dx'), dy: number(node, 'data-dy')};
    });
    var button = control.querySelector('button'), slider = control.querySelector('input');
    var output = control.querySelector('output'), pitch = number(control, 'data-pitch');
    var t = 0, last = null, running = 0, moved = false;

    function show() {
      gears.forEach(function (g) {
        g.node.setAttribute('transform', t === 0 ? g.at : g.at + ' rotate(' + g.turn * t + ')');
      });
      touches.forEach(function (c) {
        var s = t + c.tooth;
        c.node.setAttribute('visibility', moved && s >= c.from && s <= c.to ? 'visible' : 'hidden');
        c.node.setAttribute('transform', 'translate(' + c.dx * s + ' ' + c.dy * s + ')');
      });
      var words = (t * pitch).toFixed(2) + '°';
      output.textContent = words;
      slider.setAttribute('aria-valuetext', words);
    }
    function frame(now) {
      if (last !== null) t = (t + (now - last) / (1000 * secondsPerPitch)) % 1;
      last = now;
      slider.value = t;
      show();
      running = requestAnimationFrame(frame);
    }
    function stop() {
      if (running) cancelAnimationFrame(running);
      running = 0;
      last = null;
      button.textContent = 'Turn';
    }
    button.addEventListener('click', function () {
      if (running) { stop(); return; }
      moved = true;
      button.textContent = 'Stop';
      running = requestAnimationFrame(frame);
    });
    slider.addEventListener('input', function () {
      stop();
      moved = true;
      t = parseFloat(slider.value);
      show();
    });
    // Nothing moves before it is asked to; and it stops for readers who come to want no motion.
    var calm = window.matchMedia && window.matchMedia('(prefers-reduced-motion: reduce)');
    if (calm && calm.addEventListener) calm.addEventListener('change', function () { if (calm.matches) stop(); });
    window.addEventListener('beforeprint', function () {
      stop();
      t = 0;
      moved = false;
      slider.value = 0;
      show();
    });
    control.hidden = false;
    list(scope.querySelectorAll('.turn-key')).forEach(function (key) { key.hidden = false; });
  });
})();
)js";

}  // namespace

double turn_per_pitch(const InvolutePair& pair, std::size_t i) {
  GW_EXPECTS(!pair.crossed() && i < 2);
  const double one = 360.0 / std::abs(pair.gears[i].spec.teeth);
  return i == 0 || pair.kind == PairKind::parallel_internal ? one : -one;
}

std::string turn_attribute(const InvolutePair& pair, std::size_t i) {
  return fmt::format("data-turn=\"{:.12g}\"", turn_per_pitch(pair, i));
}

void draw_touches(Svg& svg, const Viewport& view, const InvolutePair& pair) {
  const Mesh<double>& mesh = pair.mesh;
  if (!pair.flanks_meet() || !(mesh.true_ratio > 0.0)) return;
  const auto at = [&](double rho1) {
    const Point<Housing> p = pair.on_line_of_action(rho1);
    return view.px({p.r.x(), p.r.y()});
  };
  const Vec2 C = at(mesh.rho1_C);
  const Vec2 step = at(mesh.rho1_C + mesh.step) - C;
  const double from = (mesh.rho1_true_begin - mesh.rho1_C) / mesh.step;
  const double to = (mesh.rho1_true_end - mesh.rho1_C) / mesh.step;
  // Tooth k touches at C + (t + k) pitches.
  for (int k = static_cast<int>(std::floor(from)); k <= static_cast<int>(std::floor(to)); ++k) {
    svg.begin_group(
        fmt::format("visibility=\"hidden\" data-tooth=\"{}\" data-from=\"{:.6f}\" "
                    "data-to=\"{:.6f}\" data-dx=\"{}\" data-dy=\"{}\"",
                    k, from, to, pixel(step.x()), pixel(step.y())));
    svg.dot(C, 5.0, "touch");
    svg.end_group();
  }
}

std::string turn_control(const InvolutePair& pair) {
  return fmt::format(
      "<div class=\"turn\" data-pitch=\"{:.12g}\" hidden><button type=\"button\">Turn</button> "
      "<label>Gear 1 <input type=\"range\" min=\"0\" max=\"1\" step=\"{:.9g}\" "
      "value=\"0\"></label> <output>0.00°</output></div>\n",
      turn_per_pitch(pair, 0), 1.0 / kSteps);
}

std::string_view turn_script() { return kScript; }

}  // namespace gearwright
