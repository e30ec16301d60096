/** Fields and commands of a wrinkle line. */
export const LINE = {
  line: 'Line',
  points: 'Points',
  width: 'Width, mm',
  depth: 'Depth, mm',
  softness: 'Softness',
  shoulder: 'Bulge',
  bank: 'Bulge width, mm',
  lean: 'Overhang',
  taper: 'Fading ends',
  reach: 'Reach, mm',
  group: 'Region',
  layer: 'Layer',
  smooth: 'Smooth',
  split: 'Split',
  mirror: 'Copy to the other side',
  detach: 'Detach',
  remove: 'Delete line',
  removeLines: 'Delete lines',
  chooseGroup: 'All of the region',
  removePoint: 'Delete point',
} as const

/** Returns the label of several chosen lines: `3 lines`. */
export function linesLabel(count: number): string {
  return `${count} lines`
}
