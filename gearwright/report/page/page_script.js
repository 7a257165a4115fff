(function () {
  'use strict';
  var svgs = document.querySelectorAll('svg.zoom');
  Array.prototype.forEach.call(svgs, function (svg) {
    var v = svg.viewBox.baseVal;
    var home = {x: v.x, y: v.y, w: v.width, h: v.height};
    var box = {x: v.x, y: v.y, w: v.width, h: v.height};
    var labels = Array.prototype.map.call(svg.querySelectorAll('.lb'), function (g) {
      return {g: g, at: g.getAttribute('transform')};
    });
    var armed = false, drag = null;

    function show() {
      var k = box.w / home.w;
      svg.setAttribute('viewBox', [box.x, box.y, box.w, box.h].join(' '));
      labels.forEach(function (l) {
        l.g.setAttribute('transform', k === 1 ? l.at : l.at + ' scale(' + k + ')');
      });
    }
    function place(event) {  // pointer in picture coordinates
      var r = svg.getBoundingClientRect();
      return {x: box.x + (event.clientX - r.left) / r.width * box.w,
              y: box.y + (event.clientY - r.top) / r.height * box.h};
    }
    function zoom(factor, p) {
      var w = Math.min(home.w * 8, Math.max(home.w / 2000, box.w * factor)), f = w / box.w;
      box = {x: p.x - (p.x - box.x) * f, y: p.y - (p.y - box.y) * f, w: w, h: box.h * f};
      show();
    }
    function reset() {
      box = {x: home.x, y: home.y, w: home.w, h: home.h};
      show();
    }
    function middle() { return {x: box.x + box.w / 2, y: box.y + box.h / 2}; }

    svg.classList.add('live');
    // If the page is scrolled past the pointer, the picture must not take the wheel. It does so
    // only after the pointer itself has moved on it.
    window.addEventListener('scroll', function () { armed = false; }, {passive: true});
    svg.addEventListener('pointerleave', function () { armed = false; });
    svg.addEventListener('wheel', function (event) {
      if (!armed && !event.ctrlKey && document.activeElement !== svg) return;
      event.preventDefault();
      var lines = event.deltaMode === 1 ? 20 : 1;
      zoom(Math.exp(Math.max(-300, Math.min(300, event.deltaY * lines)) * 0.0018), place(event));
    }, {passive: false});
    svg.addEventListener('pointerdown', function (event) {
      if (event.pointerType === 'touch' || event.button !== 0) return;
      drag = place(event);
      svg.setPointerCapture(event.pointerId);
      svg.classList.add('held');
    });
    svg.addEventListener('pointermove', function (event) {
      if (event.movementX || event.movementY) armed = true;
      if (!drag) return;
      var p = place(event);
      box.x -= p.x - drag.x;
      box.y -= p.y - drag.y;
      show();
    });
    function release() { drag = null; svg.classList.remove('held'); }
    svg.addEventListener('pointerup', release);
    svg.addEventListener('pointercancel', release);
    svg.addEventListener('dblclick', function (event) { event.preventDefault(); reset(); });
    svg.addEventListener('keydown', function (event) {
      var step = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}[event.key];
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      if (event.key === '+' || event.key === '=') zoom(1 / 1.25, middle());
      else if (event.key === '-') zoom(1.25, middle());
      else if (event.key === '0') reset();
      else if (step) { box.x += step[0] * box.w / 12; box.y += step[1] * box.h / 12; show(); }
      else return;
      event.preventDefault();
    });
    window.addEventListener('beforeprint', reset);
  });
  window.addEventListener('beforeprint', function () {
    Array.prototype.forEach.call(document.querySelectorAll('details'), function (d) { d.open = true; });
  });
  var hint = document.getElementById('hint');
  if (hint && svgs.length) hint.hidden = false;
})();
