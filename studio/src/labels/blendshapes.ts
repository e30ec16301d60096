/** Sliders of blendshapes. */
export const TARGETS = {
  filter: 'Filter blendshapes',
  example: 'Filter, e.g. brow',
  reset: 'Reset',
  resetAll: 'Reset all blendshapes',
} as const

/** List of the shapes that were recognised for blendshapes. */
export const SHAPES = {
  hint: 'Point at a blendshape, or tap its name, to see it on the face. If its shape is wrong, choose the right one.',
  recognise: 'Recognise shapes',
  recognising: 'Recognising shapes',
  recognisingOthers: 'Recognising the others again',
  outdated: 'The wrinkles were made before the last corrections.',
  makeAgain: 'Make them again',
  kept: 'The corrections are kept with the face. Wrinkles that came with it stay as they are.',
  filter: 'Filter shapes',
  unknownOnly: 'Unknown only',
  automatic: 'automatic',
  noneOfThese: 'none of these',
  none: 'none',
  unknown: 'unknown',
} as const

/** Kinds of blendshapes that are not ARKit shapes. */
export const SHAPE_KINDS: Readonly<Record<string, string>> = {
  viseme: 'speech',
  emotion: 'whole expression',
  corrective: 'correction of other shapes',
  body: 'proportion of the character',
  hidden: 'hides geometry',
  other: 'other',
}

/** Reasons for the shape of a blendshape. */
export const EVIDENCE = {
  geometry: 'motion',
  name: 'name',
  both: 'both',
  correction: 'corrected',
  none: '',
} as const

/** Returns the number of blendshapes that pass the filter: `3 found`. */
export function foundLabel(count: number): string {
  return `${count} found`
}

/** Returns the numbers of blendshapes: `12 of 52 blendshapes, 3 unknown`. @param shown number that passes the filter. */
export function shapeCountsLabel(shown: number, all: number, unknown: number): string {
  return `${shown < all ? `${shown} of ${all}` : all} blendshapes, ${unknown} unknown`
}

/** Returns the label of the field for the shape of a blendshape: `What key_12 is`. */
export function shapeChoiceLabel(blendshape: string): string {
  return `What ${blendshape} is`
}

/** Returns the option that accepts the recognised shape: `jawOpen (automatic)`. @param shape empty before recognition. */
export function automaticShapeLabel(shape: string): string {
  return shape === '' ? SHAPES.automatic : `${shape} (${SHAPES.automatic})`
}

/** Returns the option for both shapes of a pair: `mouthSmile, both sides`. */
export function bothSidesLabel(shape: string): string {
  return `${shape}, both sides`
}

/** Returns the tooltip of a blendshape's name: `Show key_12 on the face`. */
export function showShapeLabel(blendshape: string): string {
  return `Show ${blendshape} on the face`
}
