#include "gearwright/report/search_style.hpp"

namespace gearwright {

namespace {

// The colours are those of the page (report/page_style.cpp), which turn with light, dark and paper.
constexpr std::string_view kStyle = R"css(
.sheet{max-height:34rem;overflow:auto;border:1px solid var(--faint);border-radius:3px}
.sheet:focus-visible{outline:2px solid var(--link);outline-offset:2px}
table.designs{font-size:.8rem;border-collapse:separate;border-spacing:0}
.designs th,.designs td{padding:.16em .42em;border-bottom:1px solid var(--faint)}
.designs th:first-child{padding-left:.5em}.designs th:last-child,.designs td:last-child{padding-right:.6em}
.designs thead th{position:sticky;top:0;z-index:2;background:var(--paper);white-space:nowrap;vertical-align:bottom;border-bottom:1px solid var(--rule)}
.designs tbody th,.designs thead th:first-child{position:sticky;left:0;background:var(--paper);color:var(--soft);padding-right:1.1em}
.designs tbody th{z-index:1}.designs thead th:first-child{z-index:3}
.designs thead button{font:inherit;color:inherit;background:none;border:0;padding:0;margin:0;cursor:pointer;white-space:nowrap;position:relative}
.designs thead button:hover{color:var(--link)}
.designs thead button:focus-visible{outline:2px solid var(--link);outline-offset:2px;border-radius:2px}
.designs thead button::after{content:"";position:absolute;right:-.72em;bottom:0}
.designs [aria-sort=ascending] button::after{content:"▴"}.designs [aria-sort=descending] button::after{content:"▾"}
.designs [aria-sort] button{color:var(--ink);font-weight:650}
.designs tr:target td,.designs tr:target th{background:var(--grey)}
.designs tr:hover td{background:var(--panel)}
.column-key dl{display:grid;grid-template-columns:max-content 1fr;gap:.1em 1em;font-size:.9rem;margin:.6em 0}
.column-key dd{margin:0;color:var(--soft)}
table.tally{width:auto;min-width:min(100%,30rem)}
ul.reasons{padding-left:1.2em;max-width:85ch}ul.reasons li{margin:.25em 0}
.multiples figcaption{margin-top:.3em}
svg .limits-box{fill:var(--faint);fill-opacity:.55;stroke:var(--grey-ink);stroke-width:1;stroke-dasharray:2 3}
svg .region{fill:var(--alpha);fill-opacity:.28}
svg .region-edge{stroke-width:3;stroke-linecap:round}
svg .region-edge.far{stroke-dasharray:9 5}
svg .region-edge.edge-true{stroke-dasharray:3 4.5}
.edge-g1{stroke:var(--g1);color:var(--g1)}.edge-g2{stroke:var(--g2);color:var(--g2)}
.edge-c{stroke:var(--trailing);color:var(--trailing)}.edge-eps{stroke:var(--action);color:var(--action)}
.edge-true{stroke:var(--tip-fillet);color:var(--tip-fillet)}.edge-slide{stroke:var(--beta);color:var(--beta)}
.edge-clear{stroke:var(--root-land);color:var(--root-land)}.edge-hit{stroke:var(--problem);color:var(--problem)}
.edge-mesh{stroke:var(--ink);color:var(--ink)}
svg text.halo{stroke:var(--panel)}
svg text.edge-g1{fill:var(--g1)}svg text.edge-g2{fill:var(--g2)}svg text.edge-c{fill:var(--trailing)}
svg text.edge-eps{fill:var(--action)}svg text.edge-true{fill:var(--tip-fillet)}svg text.edge-slide{fill:var(--caution)}
svg text.edge-clear{fill:var(--root-land)}svg text.edge-hit{fill:var(--problem)}svg text.edge-mesh{fill:var(--ink)}
.swatch.line{height:0;border-top:3px solid currentColor;background:none;vertical-align:middle}
.swatch.line.far{border-top-style:dashed}.swatch.line.edge-true{border-top-style:dotted}
svg .region-point{fill:var(--alpha);stroke:var(--ink);stroke-width:1}
svg .region-small{stroke:var(--action);stroke-width:1.6}
svg .region-map{fill:var(--panel);stroke:var(--grey-ink);stroke-width:1}
svg .region-frame{stroke:var(--ink);stroke-width:1.2}
.distance-line{stroke:var(--trailing);stroke-width:1}
.balanced-line{stroke:var(--soft);stroke-width:1.1;stroke-dasharray:6 4}.balanced{stroke:var(--ink);stroke-width:3.4}
svg .design-ring{stroke:var(--ink);stroke-width:1.8;fill:none}
svg .design-dot{fill:var(--ink)}svg .design-small{fill:var(--ink);stroke:var(--panel);stroke-width:1}
svg text.here{fill:var(--ink);font-weight:650}
svg .room{fill:var(--alpha);fill-opacity:.22}.swatch.room{background:var(--alpha);opacity:.4}
.limit-undercut{stroke:var(--g2)}svg text.limit-undercut{fill:var(--g2)}
.limit-tip{stroke:var(--g1)}svg text.limit-tip{fill:var(--g1)}svg text.dash,svg text.dot{stroke-dasharray:none}
.share0{stroke:var(--action)}.share1{stroke:var(--tip-fillet)}.share2{stroke:var(--g1)}.share3{stroke:var(--trailing)}.share4{stroke:var(--g2)}
svg text.share0{fill:var(--action)}svg text.share1{fill:var(--tip-fillet)}svg text.share2{fill:var(--g1)}
svg text.share3{fill:var(--trailing)}svg text.share4{fill:var(--g2)}
.least-line{stroke:var(--ink);stroke-width:1.4}.least-line.dash{stroke-width:1.1}
svg .dot-design{fill:var(--g1);fill-opacity:.6;stroke:var(--panel);stroke-width:.6}
svg .dot-front{fill:var(--action);stroke:var(--panel);stroke-width:.8}
svg .dot-middle{fill:var(--panel);fill-opacity:.6;stroke:var(--soft);stroke-width:1.1}
svg .dot-design:hover,svg .dot-front:hover,svg .dot-middle:hover{stroke:var(--ink);stroke-width:2}
.staircase{stroke:var(--action);stroke-width:1.4}
@media screen and (max-width:560px){.sheet{max-height:70vh}table.designs{font-size:.75rem}
.column-key dl{grid-template-columns:1fr}.column-key dd{margin:0 0 .4em 1em}}
@page{size:A4 landscape;margin:12mm}
@media print{.sheet{max-height:none;overflow:visible;border:0}table.designs{font-size:6.6pt;border-collapse:collapse}
.designs tbody{break-inside:auto}.designs thead{break-inside:avoid}.multiples{grid-template-columns:repeat(auto-fit,minmax(36mm,1fr))}
.designs th,.designs td{padding:.08em .35em}.designs thead th,.designs tbody th,.designs thead th:first-child{position:static}.designs thead button{display:contents}.designs thead button::after{content:none!important}
#sort-hint{display:none}}
)css";

}  // namespace

std::string_view search_style() { return kStyle; }

}  // namespace gearwright
