// Turns the gears of figures. Without the script, and on paper, a figure shows its first position.
//
//   t   rotation of gear 1 from the drawn position, in pitches. After one pitch, the next tooth
//       takes the place of the first, and the figure repeats. For a drive, t is a part of its
//       period.
//
//   figureTurn(scope)   Returns a function of t that turns and moves the shapes, moves the contact
//                       points and shows the frames inside an element.
//   figureDrive(button, slider, seconds, changed, sways)   The button starts and stops a motion of
//                       one pitch in `seconds`. `changed` is called with t, in the range of the
//                       slider, and with the number of completed pitches. If `sways` is true, the
//                       motion goes to and fro, by half a pitch to either side. Returns
//                       {stop, reset}.
(function () {
  'use strict';
  function list(nodes) { return Array.prototype.slice.call(nodes); }
  function number(node, name) { return parseFloat(node.getAttribute(name)); }

  window.figureTurn = function (scope) {
    var gears = list(scope.querySelectorAll('[data-turn]')).map(function (node) {
      return {node: node, at: node.getAttribute('transform'), turn: number(node, 'data-turn')};
    });
    var bars = list(scope.querySelectorAll('[data-travel]')).map(function (node) {
      var way = node.getAttribute('data-travel').split(' ').map(parseFloat);
      return {node: node, at: node.getAttribute('transform'), dx: way[0], dy: way[1]};
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
      bars.forEach(function (b) {
        b.node.setAttribute('transform',
            t === 0 ? b.at : 'translate(' + b.dx * t + ' ' + b.dy * t + ') ' + b.at);
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

  window.figureDrive = function (button, slider, seconds, changed, sways) {
    var least = parseFloat(slider.min), way = 1, t = 0, whole = 0, last = null, running = 0;
    function frame(now) {
      if (last !== null) t += way * (now - last) / (1000 * seconds);
      last = now;
      var more = sways ? 0 : Math.floor(t - least);
      t -= more;
      whole += more;
      if (sways && Math.abs(t) > 0.5) {
        way = t > 0 ? -1 : 1;
        t = -way / 2;
      }
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
    // The gears do not move until the user starts the motion. A running motion stops if the user
    // selects reduced motion.
    var calm = window.matchMedia && window.matchMedia('(prefers-reduced-motion: reduce)');
    if (calm && calm.addEventListener) calm.addEventListener('change', function () { if (calm.matches) stop(); });
    return {stop: stop, reset: function () { stop(); way = 1; slider.value = t = whole = 0; }};
  };

  // The controls of a report. Each turns the figures of its group.
  list(document.querySelectorAll('div.turn')).forEach(function (control) {
    var scope = control.closest('.figures');
    if (!scope) return;
    var turn = window.figureTurn(scope), slider = control.querySelector('input');
    var unit = control.getAttribute('data-unit') || '°';
    function show(t, moved) {
      var words = (t * number(control, 'data-pitch')).toFixed(2) + unit;
      control.querySelector('output').textContent = words;
      slider.setAttribute('aria-valuetext', words);
      turn(t, moved);
    }
    var drive = window.figureDrive(control.querySelector('button'), slider,
        number(control, 'data-seconds') || 3, function (t) { show(t, true); },
        control.hasAttribute('data-sways'));
    window.addEventListener('beforeprint', function () {
      drive.reset();
      show(0, false);
    });
    control.hidden = false;
    list(scope.querySelectorAll('.turn-key')).forEach(function (key) { key.hidden = false; });
  });
})();
