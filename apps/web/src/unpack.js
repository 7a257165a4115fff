// Starts the self-contained page. Its parts are compressed and stored as base64 in elements of the page: the
// script by gzip, the engine by zstd.
globalThis.packedPart = (id) => {
  const letters = atob(document.getElementById(id).textContent);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  return bytes;
};
const script = new Blob([packedPart("page-script")]).stream().pipeThrough(new DecompressionStream("gzip"));
import(URL.createObjectURL(new Blob([await new Response(script).text()], { type: "text/javascript" })));
