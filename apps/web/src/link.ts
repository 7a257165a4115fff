// A link is a design: the spec, compressed, behind the # of the address, so that no server sees it.
//
//   #1.<raw DEFLATE (RFC 1951) of the UTF-8 text, as base64url (RFC 4648, no padding)>
//
// 1 is the number of this format. A link of 100 000 characters still opens in every browser; a spec
// is about 400.

const kFormat = "#1.";
/** A link that unpacks to more than this is no spec. */
const kMostCharacters = 1_000_000;

async function through(
  bytes: Uint8Array<ArrayBuffer>,
  stream: CompressionStream | DecompressionStream,
): Promise<Uint8Array<ArrayBuffer>> {
  const source = new Blob([bytes]).stream().pipeThrough(stream);
  const parts: Uint8Array<ArrayBuffer>[] = [];
  let length = 0;
  const reader = source.getReader();
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    length += value.length;
    if (length > kMostCharacters) throw new Error("the link unpacks to more than a spec can be");
    parts.push(value as Uint8Array<ArrayBuffer>);
  }
  const whole = new Uint8Array(length);
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

/** The part of an address that holds this text. */
export async function linkOf(text: string): Promise<string> {
  const packed = await through(new TextEncoder().encode(text), new CompressionStream("deflate-raw"));
  let letters = "";
  for (const byte of packed) letters += String.fromCharCode(byte);
  return kFormat + btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

/** The text in such a part; null: there is none. Throws where it is damaged. */
export async function textOf(hash: string): Promise<string | null> {
  if (!hash.startsWith(kFormat)) return null;
  const letters = atob(hash.slice(kFormat.length).replaceAll("-", "+").replaceAll("_", "/"));
  const packed = Uint8Array.from(letters, (letter) => letter.charCodeAt(0));
  const bytes = await through(packed, new DecompressionStream("deflate-raw"));
  return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
}
