export function concat(parts: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const joined = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0))
  let at = 0
  for (const part of parts) {
    joined.set(part, at)
    at += part.length
  }
  return joined
}

export function sameBytes(a: Uint8Array, b: Uint8Array): boolean {
  return a.length === b.length && a.every((byte, i) => byte === b[i])
}

/** Decodes bytes as ISO 8859-1. Accepts at most a few kilobytes, because each byte becomes an argument of one call. */
export function latin1(bytes: Uint8Array): string {
  return String.fromCharCode(...bytes)
}

/** Encodes text as ISO 8859-1. Keeps only the lower 8 bits of other characters. */
export function fromLatin1(text: string): Uint8Array {
  const bytes = new Uint8Array(text.length)
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i)
  return bytes
}

/** Decodes base64 or base64url (RFC 4648, sections 4 and 5). Skips characters outside the alphabet. */
export function fromBase64(text: string): Uint8Array {
  const digits = text
    .replaceAll('-', '+')
    .replaceAll('_', '/')
    .replace(/[^A-Za-z0-9+/]/g, '')
  // `atob` rejects a single remaining digit, which encodes less than a byte.
  return fromLatin1(atob(digits.length % 4 === 1 ? digits.slice(0, -1) : digits))
}

export function utf8(text: string): Uint8Array {
  return new TextEncoder().encode(text)
}

/** Decodes UTF-8. Keeps a byte order mark as U+FEFF, which `TextDecoder` removes by default. */
export function fromUtf8(bytes: Uint8Array): string {
  return new TextDecoder('utf-8', { ignoreBOM: true }).decode(bytes)
}
