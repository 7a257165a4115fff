// Starts the self-contained page. Its parts are compressed, the script by gzip and the engine by
// zstd, and stored as text in elements of the page. The text is in base 85, which is 6 % shorter
// than base64. Five characters represent four bytes, with the most significant character first. The
// digit d is the character with the code 40 + d, except that the digit 20 is "~" instead of "<".
globalThis.packedPart = (id) => {
  const text = document.getElementById(id).textContent;
  const bytes = new Uint8Array(Math.floor((text.length * 4) / 5));
  for (let i = 0, k = 0; i < text.length; i += 5, k += 4) {
    let group = 0;
    for (let j = i; j < i + 5; ++j) {
      const code = j < text.length ? text.charCodeAt(j) : 124;
      group = group * 85 + (code === 126 ? 20 : code - 40);
    }
    for (let j = 0; j < 4; ++j) bytes[k + j] = group >>> (24 - 8 * j); // bytes after the end are ignored
  }
  return bytes;
};
const script = new Blob([packedPart("page-script")]).stream().pipeThrough(new DecompressionStream("gzip"));
import(URL.createObjectURL(new Blob([await new Response(script).text()], { type: "text/javascript" })));
