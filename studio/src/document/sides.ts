/** What the other side of the face is called; the same name where it tells no side. */
export function otherSide(name: string): string {
  for (const [side, other] of SIDES) {
    const swapped = name.replace(side, other)
    if (swapped !== name) return swapped
  }
  return name
}

/** The end of a name that tells its side, with what is before it. */
export function splitSide(name: string): [start: string, side: string] {
  const side = name.match(/(Left|Right|[_. -][LRlr])$/)?.[0] ?? ''
  return [name.slice(0, name.length - side.length), side]
}

/** `browLeft`, `leftBrow`, `brow_left`, `brow_L`, as blendshapes and areas are named. */
const SIDES = [
  [/Left(?![a-z])/, 'Right'],
  [/Right(?![a-z])/, 'Left'],
  [/(?<![a-zA-Z])left(?![a-z])/, 'right'],
  [/(?<![a-zA-Z])right(?![a-z])/, 'left'],
  [/([_. -])L$/, '$1R'],
  [/([_. -])R$/, '$1L'],
  [/([_. -])l$/, '$1r'],
  [/([_. -])r$/, '$1l'],
] as const
