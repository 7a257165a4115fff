(function () {
  'use strict';
  var secondsPerPitch = 3;
  function list(nodes) { return Array.prototype.slice.call(nodes); }
  list(document.querySelectorAll('div.turn')).forEach(function (control) {
    var scope = control.parentNode;
    while (scope && !(scope.classList && scope.classList.contains('figures'))) scope = scope.parentNode;
    if (!scope) return;
    function number(node, name) { return parseFloat(node.getAttribute(name)); }
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
    // Some pictures are drawn for a few positions only. The script shows the one that is nearest to
    // the current position.
    var frames = list(scope.querySelectorAll('[data-frame]')).map(function (node) {
      return {node: node, at: number(node, 'data-frame'), of: number(node, 'data-frames')};
    });
    var button = control.querySelector('button'), slider = control.querySelector('input');
    var output = control.querySelector('output'), pitch = number(control, 'data-pitch');
    var seconds = number(control, 'data-seconds') || secondsPerPitch;
    var unit = control.getAttribute('data-unit') || '°';
    // A drive with a rack moves to and fro, half of its motion to either side.
    var sways = control.hasAttribute('data-sways'), way = 1;
    var t = 0, last = null, running = 0, moved = false;

    function show() {
      gears.forEach(function (g) {
        g.node.setAttribute('transform', t === 0 ? g.at : g.at + ' rotate(' + g.turn * t + ')');
      });
      bars.forEach(function (b) {
        b.node.setAttribute('transform', 'translate(' + b.dx * t + ' ' + b.dy * t + ') ' + b.at);
      });
      touches.forEach(function (c) {
        var s = t + c.tooth;
        c.node.setAttribute('visibility', moved && s >= c.from && s <= c.to ? 'visible' : 'hidden');
        c.node.setAttribute('transform', 'translate(' + c.dx * s + ' ' + c.dy * s + ')');
      });
      frames.forEach(function (f) {
        var seen = Math.round(t * f.of) % f.of === f.at;
        f.node.setAttribute('visibility', seen ? 'visible' : 'hidden');
      });
      var words = (t * pitch).toFixed(2) + unit;
      output.textContent = words;
      slider.setAttribute('aria-valuetext', words);
    }
    function frame(now) {
      if (last !== null) t += way * (now - last) / (1000 * seconds);
      if (!sways) t %= 1;
      else if (Math.abs(t) > 0.5) {
        way = t > 0 ? -1 : 1;
        t = -way / 2;
      }
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
    // Nothing moves until the user starts it. Motion stops at once if the user prefers reduced
    // motion.
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
