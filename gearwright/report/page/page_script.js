(function () {
  'use strict';
  var svgs = document.querySelectorAll('svg.zoom');
  Array.prototype.forEach.call(svgs, function (svg) {
    var zoom = figureZoom(svg);
    svg.classList.add('live');
    window.addEventListener('beforeprint', zoom.reset);
  });
  window.addEventListener('beforeprint', function () {
    Array.prototype.forEach.call(document.querySelectorAll('details'), function (d) { d.open = true; });
  });
  var hint = document.getElementById('hint');
  if (hint && svgs.length) hint.hidden = false;
})();
