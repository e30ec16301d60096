/** Labels of the brushes and the polygon. */

/** Settings that several brushes have. */
export const BRUSH = {
  size: 'Size',
  softness: 'Softness',
} as const

/** Returns the hint that strokes change the selected region. @param whole label of the button that ends the selection. */
export function intoRegion(region: string, whole: string): string {
  return `Strokes change “${region}”. Press ${whole} to begin another region.`
}

/** Brush that paints regions. */
export const PAINT = {
  add: 'Add',
  remove: 'Remove',
  smooth: 'Smooth',
  fill: 'Fill',
  flow: 'Flow',
  through: 'Paint through',
  throughHint: 'Also paint skin that the camera does not see',
  noRegion: 'Drag on a region to change it, or on bare skin to make a new one.',
  hint: 'Drag on the face. Alt, two fingers, or a drag beside the face move the camera. Keys: [ and ] for the size, X for add or remove, Esc to take a stroke back.',
} as const

export const POLYGON = {
  feather: 'Feather',
  close: 'Close polygon',
  clear: 'Clear',
  hint: 'Click points on the face or on its texture. Enter, or a click on the first point, closes the polygon; Backspace takes the last point back, Esc all of them.',
} as const

export const SCULPT = {
  raise: 'Raise',
  lower: 'Lower',
  smooth: 'Smooth',
  flatten: 'Flatten',
  height: 'Height, mm',
  strength: 'Strength',
  noRegion: 'Strokes get a region of their own.',
  stamp: 'Stamp…',
  stampTitle: 'A gray image that shapes the brush: white has the full effect',
  removeStamp: 'Remove the stamp',
  hint: 'Drag on the face. A harder press of a pen has more effect. Keys: [ and ] for the size, X for raise or lower, M for both halves, Esc to take a stroke back.',
} as const
