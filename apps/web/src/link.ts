// A link contains a design. The compressed spec is in the fragment of the address, after the #, which the
// browser sends to no server.
//
//   #1.<raw DEFLATE (RFC 1951) of the UTF-8 text, as base64url (RFC 4648, no padding)>
//
// The 1 is the version of this format. Every browser opens a link of 100 000 characters. A usual spec needs
// about 400.

import { kMostCharacters } from "./workbench";

const kFormat = "#1.";
const kAgain = "Copy it again, from its first to its last character.";

class TooLong extends Error {}

async function through(
  bytes: Uint8Array<ArrayBuffer>,
  stream: CompressionStream | DecompressionStream,
): Promise<Uint8Array<ArrayBuffer>> {
  const parts: Uint8Array<ArrayBuffer>[] = [];
  let length = 0;
  const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader();
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    length += part.value.length;
    if (length > kMostCharacters) {
      void reader.cancel();
      throw new TooLong();
    }
    parts.push(part.value as Uint8Array<ArrayBuffer>);
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}

/** Returns the fragment that contains this text. */
export async function linkOf(text: string): Promise<string> {
  const packed = await through(new TextEncoder().encode(text), new CompressionStream("deflate-raw"));
  let letters = "";
  for (const byte of packed) letters += String.fromCharCode(byte);
  return kFormat + btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

/** Returns the text in a fragment, or null if it contains none. If the fragment is damaged, throws
 *  an Error with a sentence for the user. */
export async function textOf(hash: string): Promise<string | null> {
  if (!hash.startsWith(kFormat)) return null;
  const packed = hash.slice(kFormat.length);
  const strange = /[^A-Za-z0-9_-]/u.exec(packed)?.[0];
  if (strange)
    throw new Error(`This link is damaged, because a link cannot contain the character “${strange}”. ${kAgain}`);
  try {
    const letters = atob(packed.replaceAll("-", "+").replaceAll("_", "/"));
    const bytes = Uint8Array.from(letters, (letter) => letter.charCodeAt(0));
    const whole = await through(bytes, new DecompressionStream("deflate-raw"));
    return new TextDecoder("utf-8", { fatal: true }).decode(whole);
  } catch (reason) {
    throw new Error(
      reason instanceof TooLong
        ? "This link contains more than a million characters, the limit for a spec."
        : `This link is damaged, because characters are missing or changed. ${kAgain}`,
    );
  }
}
