/** Swaps left and right in the name of a blendshape or an area, if it contains a side. */
export function otherSide(name: string): string {
  for (const [side, other] of SIDES) {
    const swapped = name.replace(side, other)
    if (swapped !== name) return swapped
  }
  return name
}

/** Splits a name into its stem and its side suffix. */
export function splitSide(name: string): [start: string, side: string] {
  const side = name.match(/(Left|Right|[_. -][LRlr])$/)?.[0] ?? ''
  return [name.slice(0, name.length - side.length), side]
}

/** Spellings of sides in names, with their replacements: `browLeft`, `leftBrow`, `brow_left`, `brow_L`. */
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
