#include "gearwright/report/page_style.hpp"

namespace gearwright {

namespace {

constexpr std::string_view kStyle = R"css(
:root{color-scheme:light dark;--paper:#fff;--panel:#f7f8f9;--ink:#1a1f24;--soft:#57606a;--rule:#d5dadf;
--faint:#e9ecef;--grey:#dfe3e7;--grey-ink:#9aa3ab;--g1:#0067a6;--g1-fill:#d4e6f3;--g2:#b54708;
--g2-fill:#f8e1d0;--action:#8b1a7c;--trailing:#00796b;--alpha:#4e95c9;--beta:#e0a33a;--more:#bcd9ee;--fewer:#f6dfae;
--root-land:#4d5a66;--root-fillet:#d55e00;--flank:#0072b2;--tip-fillet:#b8478d;--tip-land:#00855f;
--problem:#b42318;--caution:#9a6700;--note:#57606a;--link:#0b5cad}
@media (prefers-color-scheme:dark){:root{--paper:#14181c;--panel:#1b2026;--ink:#e4e8ec;--soft:#a2acb6;
--rule:#39424b;--faint:#262d34;--grey:#2b3238;--grey-ink:#6b757f;--g1:#6cb6ee;--g1-fill:#1d3a50;
--g2:#f2a06a;--g2-fill:#4a2d1a;--action:#e58bd8;--trailing:#4fd1c0;--alpha:#3d83b8;--beta:#b67d1f;--more:#27506e;
--fewer:#5b4a1c;--root-land:#b4bfca;--root-fillet:#ff8c42;--flank:#56b4e9;--tip-fillet:#e78ac3;
--tip-land:#3fc79a;--problem:#ff8a80;--caution:#e8b84a;--note:#a2acb6;--link:#7fbcf5}}
*{box-sizing:border-box}
html{-webkit-text-size-adjust:100%}
body{margin:0;background:var(--paper);color:var(--ink);font:16px/1.5 system-ui,-apple-system,"Segoe UI",
Roboto,"Noto Sans","DejaVu Sans",sans-serif}
main,header,footer{max-width:1120px;margin:0 auto;padding:0 24px}
header{padding-top:36px}
h1{font-size:1.75rem;line-height:1.2;margin:.1em 0 .35em;font-weight:650;overflow-wrap:anywhere}
h2{font-size:1.2rem;margin:2.4em 0 .8em;padding-bottom:.3em;border-bottom:1px solid var(--rule);font-weight:650}
h3{font-size:1.02rem;margin:1.6em 0 .8em;font-weight:650}
.kind{color:var(--soft);margin:0;font-size:.9rem}
.verdict{font-size:1.1rem;margin:.2em 0 1.2em;max-width:70ch}
a{color:var(--link)}
ul.warnings{list-style:none;margin:0;padding:0}
ul.warnings li{border-left:4px solid;padding:.35em .9em;margin:0 0 .45em;background:var(--panel)}
ul.warnings b{margin-right:.5em}
ul.warnings .where{color:var(--soft);margin-right:.5em}
.problem{border-color:var(--problem)!important}.problem b{color:var(--problem)}
.caution{border-color:var(--caution)!important}.caution b{color:var(--caution)}
.note{border-color:var(--note)!important}.note b{color:var(--note)}
.columns{display:grid;grid-template-columns:minmax(0,1fr) minmax(0,1fr);gap:0 36px;align-items:start}
.scroll{overflow-x:auto;margin:0 0 1.4em}
table{border-collapse:collapse;width:100%;font-size:.9rem;font-variant-numeric:tabular-nums lining-nums}
caption{text-align:left;font-weight:650;padding:.2em 0 .5em}
th,td{padding:.2em .55em;text-align:left;border-bottom:1px solid var(--faint);font-weight:400;vertical-align:baseline}
th:first-child{padding-left:0}
th:last-child,td:last-child{padding-right:0}
thead th{color:var(--soft);border-bottom:1px solid var(--rule);font-size:.92em}
tr.group th{padding-top:.9em;font-weight:650;font-size:.92em;color:var(--soft);border-bottom-color:var(--rule)}
.value{text-align:right;white-space:nowrap}
.unit{color:var(--soft);white-space:nowrap}
.symbol{white-space:nowrap}
var{font-style:italic;font-family:"Cambria Math","STIX Two Text","Times New Roman","DejaVu Serif",serif}
sub,sup{font-size:.72em;line-height:0}
.figures{display:grid;grid-template-columns:minmax(0,1fr) minmax(0,1fr);gap:24px 36px;align-items:start}
.figures.mesh{grid-template-columns:minmax(0,3fr) minmax(0,2fr)}
.multiples{display:grid;grid-template-columns:repeat(auto-fit,minmax(150px,1fr));gap:14px}.multiples .own svg{border-color:var(--soft)}
.turn{display:flex;align-items:center;gap:.8em;margin:.6em 0 0;font-size:.85rem}.turn[hidden],.key[hidden]{display:none}
.turn label{display:flex;align-items:center;gap:.6em;flex:1;min-width:0}.turn input{flex:1;min-width:0;accent-color:var(--g1)}
.turn output{min-width:4.2em;text-align:right;font-variant-numeric:tabular-nums}
.turn button{font:inherit;min-width:4.2em;padding:.25em .8em;color:var(--ink);background:var(--panel);border:1px solid var(--grey-ink);border-radius:3px;cursor:pointer}
.turn button:focus-visible,.turn input:focus-visible{outline:2px solid var(--link);outline-offset:2px}
.nopicture{background:var(--panel);border-left:4px solid var(--rule);padding:.6em 1em;margin:0 0 1.2em}
figure{margin:0 0 1em;min-width:0}
figcaption{font-size:.85rem;color:var(--soft);margin-top:.5em}
figcaption strong{color:var(--ink);font-weight:650}
.key{white-space:nowrap;margin-right:.6em}
.swatch{display:inline-block;width:1.1em;height:.62em;margin-right:.35em;border-radius:1px;background:currentColor}
.swatch.alpha{background:var(--alpha)}.swatch.beta{background:var(--beta)}
.hint{font-size:.85rem;color:var(--soft);margin:-.4em 0 1.2em}
svg.zoom{display:block;width:100%;height:auto;background:var(--panel);border:1px solid var(--faint);border-radius:3px;overflow:hidden}
svg.live{cursor:grab}svg.held{cursor:grabbing}
svg.zoom:focus-visible{outline:2px solid var(--link);outline-offset:2px}
svg text{font:13px system-ui,-apple-system,"Segoe UI",Roboto,"Noto Sans","DejaVu Sans",sans-serif;fill:var(--ink);
font-variant-numeric:tabular-nums;user-select:none;-webkit-user-select:none}
svg .m{text-anchor:middle}svg .e{text-anchor:end}
svg tspan.s{font-size:9.5px}svg tspan.v{font-style:italic}
svg .tick{fill:var(--soft);font-size:12px}
svg .letter{font-weight:650;font-size:14px}svg .inzone{font-size:12px}
svg .halo{paint-order:stroke;stroke:var(--panel);stroke-width:4px;stroke-linejoin:round}
svg path,svg circle,svg polyline,svg polygon,svg rect,svg use{vector-effect:non-scaling-stroke;fill:none;stroke-linejoin:round}
.definitions *{fill:inherit}
.neighbour{fill:var(--grey);stroke:var(--grey-ink);stroke-width:1}
.outline{stroke-width:1.3}#whole .outline{stroke-width:.9}.outline.g1{stroke:var(--g1)}.outline.g2{stroke:var(--g2)}
svg use.neighbour{fill:var(--grey)}svg use.body.g1{fill:var(--g1-fill)}svg use.body.g2{fill:var(--g2-fill)}
.thin{stroke:var(--soft);stroke-width:1}
.thin.g1,.turn.g1,.curve.g1{stroke:var(--g1)}.thin.g2,.turn.g2,.curve.g2{stroke:var(--g2)}
.dash{stroke-dasharray:7 4}.dashdot{stroke-dasharray:12 4 2 4}.dot{stroke-dasharray:1.5 3}
.leader{stroke:var(--grey-ink);stroke-width:.8}
.arc{stroke-width:2.8;stroke-linecap:butt}
.c-root-land{stroke:var(--root-land);color:var(--root-land)}.c-root-fillet{stroke:var(--root-fillet);color:var(--root-fillet)}
.c-flank{stroke:var(--flank);color:var(--flank)}.c-tip-fillet{stroke:var(--tip-fillet);color:var(--tip-fillet)}
.c-tip-land{stroke:var(--tip-land);color:var(--tip-land)}
.swatch.g1{background:var(--g1)}.swatch.g2{background:var(--g2)}.swatch.action{background:var(--action)}
.swatch.before{background:none;height:0;border-top:2px dashed var(--ink);vertical-align:middle}
.swatch.touch{width:.75em;height:.75em;border-radius:50%;background:none;border:2px solid var(--action)}
.swatch.trailing{background:var(--trailing)}.swatch.ink{background:var(--ink)}
svg .mark{fill:var(--ink)}svg .mark.g1{fill:var(--g1)}svg .mark.g2{fill:var(--g2)}
svg .action-dot{fill:var(--action)}svg .pitch-dot{fill:var(--ink)}
.before{stroke:var(--ink);stroke-width:1.5;stroke-dasharray:5 3}.kept{stroke:var(--soft);stroke-width:1.8}
svg .slice{fill:var(--grey)}svg .touch{fill:var(--paper);fill-opacity:.7;stroke:var(--action);stroke-width:2}.full{stroke-width:1.8}
svg .mark.hollow{fill:var(--panel);stroke:var(--soft);stroke-width:1.2}
svg text.g1{fill:var(--g1)}svg text.g2{fill:var(--g2)}
.action{stroke:var(--action);stroke-width:3}.action-line{stroke:var(--action);stroke-width:1;stroke-dasharray:3 3}
.trailing{stroke:var(--trailing);stroke-width:3;stroke-dasharray:9 4}.trailing-line{stroke:var(--trailing);stroke-width:1;stroke-dasharray:3 3}
svg .reached{stroke-width:1.2;stroke-dasharray:none}svg .trailing-dot{fill:var(--trailing)}
svg .mark.ring{fill:none;stroke:var(--ink);stroke-width:1.2}
svg .band{fill:var(--more);opacity:.38}
svg polyline.here{stroke:var(--action);stroke-width:1.2}svg text.here{fill:var(--action)}
svg polyline.least{stroke:var(--soft);stroke-width:1.2;stroke-dasharray:7 4}
svg text.panel{font-weight:650;font-size:13px}
.curve.ink{stroke:var(--ink)}.curve.action-curve{stroke:var(--action)}.curve.trailing-curve{stroke:var(--trailing)}
.face-line{stroke:var(--ink);stroke-width:1.2;stroke-dasharray:2 3}.face-line.g1{stroke:var(--g1)}.face-line.g2{stroke:var(--g2)}
svg .face.g1{fill:var(--g1-fill);stroke:var(--g1);fill-opacity:.6}svg .face.g2{fill:var(--g2-fill);stroke:var(--g2);fill-opacity:.6}
svg .solid.g1{fill:var(--g1-fill);stroke:var(--g1)}svg .solid.g2{fill:var(--g2-fill);stroke:var(--g2);fill-opacity:.62}
.tooth-line{stroke-width:.8;opacity:.6}.tooth-line.g1{stroke:var(--g1)}.tooth-line.g2{stroke:var(--g2)}
.plane{stroke-width:1.2}.plane.g1{stroke:var(--g1)}.plane.g2{stroke:var(--g2)}
.frame{stroke:var(--ink);stroke-width:1.2;stroke-dasharray:5 3}
.cross{stroke:var(--ink);stroke-width:1.2}.turn{stroke-width:1.8}
svg .head.g1{fill:var(--g1)}svg .head.g2{fill:var(--g2)}
.grid{stroke:var(--faint);stroke-width:1}.axis{stroke:var(--soft);stroke-width:1}.one{stroke:var(--ink);stroke-width:1.4}
.curve{stroke-width:2.2}
svg .zone{stroke:var(--paper);stroke-width:1}svg .zone.more{fill:var(--more)}svg .zone.fewer{fill:var(--fewer)}
svg .zone.none{fill:none;stroke:var(--problem);stroke-dasharray:4 3}
.usable{stroke:var(--ink);stroke-width:3}
svg .bar.alpha{fill:var(--alpha)}svg .bar.beta{fill:var(--beta)}svg .bar.formula{stroke:var(--ink);stroke-width:1.2}
.tp0{stroke:var(--flank)}.tp1{stroke:var(--root-fillet)}.tp2{stroke:var(--tip-land)}
svg .lane{stroke-width:1;fill-opacity:.34}svg .lane.tp0{fill:var(--flank)}svg .lane.tp1{fill:var(--root-fillet)}svg .lane.tp2{fill:var(--tip-land)}
svg .lane.inside{fill:var(--alpha);stroke:var(--alpha)}svg .lane.edge{fill:var(--root-fillet);stroke:var(--root-fillet)}
svg .measured{fill:var(--faint);fill-opacity:.75}.handover{stroke:var(--ink);stroke-width:1.2;stroke-dasharray:1.5 3}
svg .flank-ground{fill:var(--paper)}.limit{stroke:var(--ink);stroke-width:1.3}.instant{stroke:var(--ink);stroke-width:.9}
svg .marked{fill:var(--flank);fill-opacity:.32;stroke:var(--flank);stroke-width:1.8}
.edge-way{stroke:var(--root-fillet);stroke-width:4.5;stroke-dasharray:6 2.5}svg .edge-dot{fill:var(--root-fillet)}
svg .way-begin{fill:var(--panel);stroke:var(--ink);stroke-width:1.8}svg .cut-solid.g1{fill:var(--g1-fill)}svg .cut-solid.g2{fill:var(--g2-fill)}
svg .gap-band{fill:var(--flank);fill-opacity:.14;stroke:var(--flank);stroke-width:1}
svg .s0{fill:#00204d}svg .s1{fill:#0b3370}svg .s2{fill:#37476b}svg .s3{fill:#555b6d}svg .s4{fill:#6f7073}
svg .s5{fill:#8a8779}svg .s6{fill:#a69d75}svg .s7{fill:#c4b56c}svg .s8{fill:#e4cf5b}svg .s9{fill:#ffea46}
.step{stroke:#fff;stroke-opacity:.6;stroke-width:.8}svg .here-ring{stroke:#fff;stroke-width:2.4}svg .here-dot{fill:#fff;stroke:#000;stroke-width:1}
.swatch.marked{background:var(--flank);opacity:.55}.swatch.edge-way{background:repeating-linear-gradient(90deg,var(--root-fillet) 0 5px,transparent 5px 7px)}
.swatch.instant{background:none;border:1.5px solid var(--ink);border-radius:50%}.swatch.instant-line{height:0;border-top:1.5px solid var(--ink);vertical-align:middle}
ul.assumed{margin:.4em 0 1.2em;padding-left:1.2em;font-size:.95rem}.contact p{max-width:80ch}
details{margin:1em 0}summary{cursor:pointer;font-weight:650}
pre{background:var(--panel);border:1px solid var(--faint);padding:1em;overflow-x:auto;font:13px/1.45 ui-monospace,
"SF Mono",Menlo,Consolas,"DejaVu Sans Mono",monospace;tab-size:4}
.definitions{position:absolute;width:0;height:0}
footer{color:var(--soft);font-size:.85rem;border-top:1px solid var(--rule);margin-top:3em;padding-top:1em;padding-bottom:3em}
footer p{margin:.4em 0;max-width:90ch}section>p,.columns p{font-size:.95rem}
@media screen and (max-width:900px){.columns,.figures,.figures.mesh{grid-template-columns:minmax(0,1fr)}}
@media screen and (max-width:560px){main,header,footer{padding-left:14px;padding-right:14px}header{padding-top:20px}
h1{font-size:1.4rem}.verdict{font-size:1rem}table{font-size:.8rem}th,td{padding:.2em .35em}
svg text{font-size:16px}svg .tick{font-size:15px}svg .inzone{font-size:15px}svg .letter{font-size:18px}svg text.panel{font-size:15px}svg tspan.s{font-size:12px}}
@media print{:root{color-scheme:light;--paper:#fff;--panel:#fff;--ink:#000;--soft:#444;--rule:#bbb;--faint:#ddd;--grey:#e6e8ea;
--grey-ink:#8a939b;--g1:#0067a6;--g1-fill:#dbe9f4;--g2:#b54708;--g2-fill:#f8e4d6;--action:#8b1a7c;--trailing:#00796b;--alpha:#4e95c9;--beta:#e0a33a;
--more:#bcd9ee;--fewer:#f6dfae;--root-land:#4d5a66;--root-fillet:#d55e00;--flank:#0072b2;--tip-fillet:#b8478d;--tip-land:#00855f;
--problem:#b42318;--caution:#9a6700;--note:#57606a;--link:#000}
@page{size:A4;margin:15mm 14mm}
body{font-size:10pt;-webkit-print-color-adjust:exact;print-color-adjust:exact}
main,header,footer{max-width:none;padding:0}header{padding-top:0}
.hint,summary,.turn,.turn-key{display:none}
h1{font-size:17pt}h2{font-size:12pt;break-after:avoid;margin:1.2em 0 .6em}.verdict{font-size:11pt}
ul.warnings,section>p,.columns p,.nopicture{font-size:9.5pt}figcaption,footer p{font-size:8pt}
figure,tr,li,tbody,caption{break-inside:avoid}caption,thead,tr.group{break-after:avoid}thead{display:table-header-group}
table{font-size:8pt;line-height:1.35}th,td{padding:.1em .5em}tr.group th{padding-top:.5em}.scroll{overflow:visible;margin-bottom:1em}
.figures{gap:8px 24px}.multiples{grid-template-columns:repeat(auto-fit,minmax(31mm,1fr))}.columns{display:block}
.columns>div+div{display:grid;grid-template-columns:minmax(0,1fr) minmax(0,1fr);gap:8px 24px;align-items:start}
.columns>div+div>.scroll{grid-column:1/-1}.columns>div:first-child>figure{max-width:56%}
pre{white-space:pre-wrap;font-size:8pt;border:0;padding:0}
svg.zoom{border-color:#ccc}footer{margin-top:1.5em}a{text-decoration:none}}
)css";

constexpr std::string_view kScript = R"js(
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
    // A page that is being scrolled past the pointer must not stop here: the wheel is the picture's
    // once the pointer itself has moved on it.
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
)js";

}  // namespace

std::string_view page_style() { return kStyle; }

std::string_view page_script() { return kScript; }

}  // namespace gearwright
