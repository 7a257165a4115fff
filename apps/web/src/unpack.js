// Starts the one file: its parts are gzip as base64 in elements of the page.
globalThis.unpacked = (id) => {
  const letters = atob(document.getElementById(id).textContent);
  const packed = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) packed[i] = letters.charCodeAt(i);
  return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip")));
};
const script = await unpacked("page-script").text();
import(URL.createObjectURL(new Blob([script], { type: "text/javascript" })));
