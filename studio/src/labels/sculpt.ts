/** Labels of the brush that sculpts. */

export const SCULPT = {
  raise: 'Raise',
  lower: 'Lower',
  smooth: 'Smooth',
  flatten: 'Flatten',
  size: 'Size',
  softness: 'Softness',
  height: 'Height, mm',
  strength: 'Strength',
  stamp: 'Stamp…',
  stampTitle: 'A gray image that shapes the brush: white has the full effect',
  removeStamp: 'Remove the stamp',
  sculpted: 'Sculpted heights',
  reset: 'Reset sculpting',
  hint: 'Drag on the face. A harder press of a pen has more effect. Keys: [ and ] for the size, X for raise or lower, M for both halves, Esc to take a stroke back.',
} as const
