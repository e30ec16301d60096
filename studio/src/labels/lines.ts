/** Fields and commands of a wrinkle line. */
export const LINE = {
  line: 'Line',
  none: 'None',
  noGroup: 'Without a region',
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

/** Returns the name of a point of the line, for screen readers: `Point 2 of 5, a fork`. */
export function linePointLabel(number: number, count: number, isFork: boolean): string {
  return `Point ${number} of ${count}${isFork ? ', a fork' : ''}`
}

/** Returns the tooltip of a point of the line. */
export function linePointHint({ isFork, isRemovable }: { isFork: boolean; isRemovable: boolean }): string {
  const moves = isFork ? 'Arrow keys move it with all lines that meet there' : 'Arrow keys move it'
  return isRemovable ? `${moves}, Delete removes it` : moves
}
