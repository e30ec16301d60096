/** Names of the types of drivers. */
export const DRIVER_TYPES = {
  morph: 'Blendshapes',
  area: 'Other areas',
  tension: 'Skin tension',
  bone: 'Joint',
  age: 'Age',
  input: 'Number',
  muscle: 'Muscle',
  time: 'Delay',
  expression: 'Expression',
} as const

/** List of a region's drivers. */
export const DRIVERS = {
  type: 'Driver to add',
  add: 'Add driver',
  none: 'Only its slider moves this region. Add a driver.',
  activation: 'Activation now',
  contribution: 'Current contribution',
  remove: 'Remove this driver',
  removeThis: 'Remove it',
  removeConflict: 'Remove the conflict',
} as const

/** Expressions that show a region, and its strongest drivers. */
export const WHEN = {
  expressions: 'Expressions that show it',
  noExpression: 'No expression of this avatar shows it.',
  strongest: 'Strongest drivers',
  noDriver: 'No expression shows it, only its slider.',
  always: 'It is always visible. No expression changes it.',
} as const

/** Pairs of blendshapes that cancel each other. */
export const CONFLICTS = {
  title: 'Opposite blendshapes',
  hint: 'Two blendshapes that undo each other, such as raising and lowering a brow. If both are active, the smaller weight is taken from both before drivers read them. The face itself does not change.',
  add: 'Add a conflict',
  one: 'One side',
  other: 'Other side',
  remove: 'Remove',
} as const

/** Inputs of a driver: blendshapes or areas. */
export const LINKS = {
  blendshape: 'blendshape',
  area: 'area',
  curve: 'Curve for this input',
  remove: 'Remove',
} as const

/** Editor for a curve. */
export const CURVE = {
  hint: 'Drag the points; a double click adds one',
  gives: 'gives',
  add: 'Add a point',
  remove: 'Remove this point',
} as const

/** Returns the label of problems with drivers: `1 problem`. */
export function problemsLabel(count: number): string {
  return count === 1 ? '1 problem' : `${count} problems`
}

/** Returns how much of a region an expression shows: `Smile shows it to 80%`. @param activation 0..1. */
export function shownByLabel(expression: string, activation: number): string {
  return `${expression} shows it to ${Math.round(100 * activation)}%`
}

/** Returns the activation that an input gives alone: `Gives 0.80 when it is full`. */
export function fullLabel(activation: number): string {
  return `Gives ${activation.toFixed(2)} when it is full`
}

/** Returns the weight that a conflict takes from both blendshapes: `0.60 is taken from both now`. */
export function takenLabel(weight: number): string {
  return `${weight.toFixed(2)} is taken from both now`
}

/** Returns the name of the button that removes a conflict, for screen readers. */
export function removeConflictLabel(one: string, other: string): string {
  return `Remove the conflict of ${one} and ${other}`
}

/** Returns the label of one of several inputs: `blendshape 2`. @param noun kind of input. */
export function linkLabel(noun: string, number: number): string {
  return `${noun} ${number}`
}

/** Returns the label of the field that adds an input: `Add blendshape`. */
export function addLinkLabel(noun: string): string {
  return `Add ${noun}`
}

/** Returns the first option of the field that adds an input: `Add blendshape…`. */
export function addLinkOption(noun: string): string {
  return `${addLinkLabel(noun)}…`
}

/** Returns the label of the field for an input's factor. */
export function factorLabel(input: string): string {
  return `Factor of ${input}`
}

/** Returns the name of a curve, by its input. */
export function curveLabel(input: string): string {
  return `Curve of ${input}`
}

/** Returns the name of the curve of one input, before inputs are combined: `browInnerUp alone`. */
export function aloneLabel(input: string): string {
  return `${input} alone`
}

/** Returns the name of the button that removes an input, for screen readers. */
export function removeLinkLabel(input: string): string {
  return `Remove ${input}`
}

/** Returns the label of a point of a curve in its field: `Point 2`. */
export function curvePointLabel(number: number): string {
  return `Point ${number}`
}

/** Returns the label of a point on the curve for screen readers: `Point 2 of 3`. */
export function curvePointOfLabel(number: number, count: number): string {
  return `Point ${number} of ${count}`
}

/** Returns the position of a point for screen readers: `browInnerUp 0.5 gives 1`. @param at input with its unit. */
export function curveValueLabel(input: string, at: string, output: number): string {
  return `${input} ${at} gives ${output}`
}

/** Returns the name of the button that removes a point of a curve, for screen readers. */
export function removeCurvePointLabel(number: number): string {
  return `Remove point ${number}`
}

/** Returns the current input and output of a curve: `Now: 45° gives 0.50`. @param at input with its unit. */
export function curveNowLabel(at: string, output: number): string {
  return `Now: ${at} gives ${output.toFixed(2)}`
}
