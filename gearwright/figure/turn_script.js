// Turns the gears of figures. Without the script, and on paper, a figure shows its first position.
//
//   t   rotation of gear 1 from the drawn position, in pitches. After one pitch, the next tooth takes
//       the place of the first, and the figure repeats. For a drive, t is a part of its period.
//
//   figureTurn(scope)   Returns a function of t that turns the shapes, moves the contact points and
//                       shows the frames inside an element.
//   figureDrive(button, slider, seconds, changed)   The button starts and stops a motion of one pitch
//                       in `seconds`. `changed` is called with t, in the range of the slider, and
//                       with the number of completed pitches. Returns {stop, reset}.
(function () {
  'use strict';
  function list(nodes) { return Array.prototype.slice.call(nodes); }
  function number(node, name) { return parseFloat(node.getAttribute(name)); }

  window.figureTurn = function (scope) {
    var gears = list(scope.querySelectorAll('[data-turn]')).map(function (node) {
      return {node: node, at: node.getAttribute('transform'), turn: number(node, 'data-turn')};
    });
    var touches = list(scope.querySelectorAll('[data-tooth]')).map(function (node) {
      return {node: node, tooth: number(node, 'data-tooth'), from: number(node, 'data-from'),
              to: number(node, 'data-to'), dx: number(node, 'data-dx'), dy: number(node, 'data-dy')};
    });
    // Some figures are drawn for a few positions only. The script shows the one that is nearest to
    // the current position.
    var frames = list(scope.querySelectorAll('[data-frame]')).map(function (node) {
      return {node: node, at: number(node, 'data-frame'), of: number(node, 'data-frames')};
    });
    return function (t, moved) {
      gears.forEach(function (g) {
        g.node.setAttribute('transform', t === 0 ? g.at : g.at + ' rotate(' + g.turn * t + ')');
      });
      touches.forEach(function (c) {
        var s = t + c.tooth;
        c.node.setAttribute('visibility', moved && s >= c.from && s <= c.to ? 'visible' : 'hidden');
        c.node.setAttribute('transform', 'translate(' + c.dx * s + ' ' + c.dy * s + ')');
      });
      frames.forEach(function (f) {
        var seen = (Math.round(t * f.of) % f.of + f.of) % f.of === f.at;
        f.node.setAttribute('visibility', seen ? 'visible' : 'hidden');
      });
    };
  };

  window.figureDrive = function (button, slider, seconds, changed) {
    var least = parseFloat(slider.min), t = 0, whole = 0, last = null, running = 0;
    function frame(now) {
      if (last !== null) t += (now - last) / (1000 * seconds);
      last = now;
      var more = Math.floor(t - least);
      t -= more;
      whole += more;
      slider.value = t;
      running = requestAnimationFrame(frame);
      changed(t, whole);
    }
    function stop() {
      cancelAnimationFrame(running);
      running = 0;
      last = null;
      button.textContent = 'Turn';
    }
    button.addEventListener('click', function () {
      if (running) { stop(); return; }
      button.textContent = 'Stop';
      running = requestAnimationFrame(frame);
    });
    slider.addEventListener('input', function () {
      stop();
      t = parseFloat(slider.value);
      changed(t, whole);
    });
    // The gears do not move until the user starts the motion. The motion stops at once if the user
    // prefers reduced motion.
    var calm = window.matchMedia && window.matchMedia('(prefers-reduced-motion: reduce)');
    if (calm && calm.addEventListener) calm.addEventListener('change', function () { if (calm.matches) stop(); });
    return {stop: stop, reset: function () { stop(); slider.value = t = whole = 0; }};
  };

  // The controls of a report. Each turns the figures of its group.
  list(document.querySelectorAll('div.turn')).forEach(function (control) {
    var scope = control.closest('.figures');
    if (!scope) return;
    var turn = window.figureTurn(scope), slider = control.querySelector('input');
    function show(t, moved) {
      var words = (t * number(control, 'data-pitch')).toFixed(2) + '°';
      control.querySelector('output').textContent = words;
      slider.setAttribute('aria-valuetext', words);
      turn(t, moved);
    }
    var drive = window.figureDrive(control.querySelector('button'), slider,
        number(control, 'data-seconds') || 3, function (t) { show(t, true); });
    window.addEventListener('beforeprint', function () {
      drive.reset();
      show(0, false);
    });
    control.hidden = false;
    list(scope.querySelectorAll('.turn-key')).forEach(function (key) { key.hidden = false; });
  });
})();
