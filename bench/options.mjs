// Parsers of command line options that several benchmarks share. They throw if the text is invalid.

export function parseRounds(text) {
  if (/^[1-9]\d?$/.test(text)) return Number(text)
  throw new Error(`bench: invalid rounds, got "${text}", allowed: 1 to 99; write e.g. --rounds 5`)
}

export function parseSize(text) {
  const match = /^([1-9]\d{0,3})x([1-9]\d{0,3})$/.exec(text)
  if (match) return { width: Number(match[1]), height: Number(match[2]) }
  throw new Error(
    `bench: invalid size, got "${text}", allowed: 1x1 to 9999x9999; write e.g. --size 3840x2160`,
  )
}
