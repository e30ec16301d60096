import { regionLabel } from './names.ts'

/** Fields and commands of a wrinkle line. */
export const LINE = {
  line: 'Line',
  none: 'None',
  noGroup: 'Without a region',
  points: 'Points',
  width: 'Width, mm',
  depth: 'Depth, mm',
  softness: 'Softness',
  shoulder: 'Raised edges',
  bank: 'Edge distance, mm',
  lean: 'Steeper side',
  taper: 'Fading ends',
  reach: 'Reach, mm',
  group: 'Region',
  groupUnder: 'The region under it',
  newGroup: 'A new name: a new one',
  layer: 'Layer',
  layerOfGroup: 'The layer of the region',
  smooth: 'Smooth',
  split: 'Split',
  mirror: 'Copy to the other side',
  detach: 'Detach from other line',
  remove: 'Delete line',
  removeLines: 'Delete lines',
  chooseGroup: 'All of the region',
  removePoint: 'Delete point',
  chosenLine: 'Chosen line',
  chosenLines: 'Chosen lines',
} as const

/** Effects of the commands. */
export const LINE_ACTIONS = {
  smooth: 'Removes jitter, and keeps bends',
  split: 'At the chosen point, or in the middle',
  mirror: 'Adds its mirror image',
  detach: 'Shortens the line where it ends on another line',
  removePoint: 'Removes the chosen point',
  chooseGroup: 'Chooses all lines of the region',
} as const

/** Hints for the tools, and for a chosen line. */
export const LINE_HINTS = {
  off: 'Every wrinkle is a line.',
  select: 'Drag across the line to make it deeper. Shift+click chooses several lines.',
  edit: 'Drag a line on the face, or choose one above. Shift+click chooses several lines.',
  chosen:
    'Drag the line or a point. Points within the reach follow. The keys [ and ] change the reach; with Alt, a point moves alone. Shift+click or double-click adds a point, Delete removes it.',
  fork: 'A diamond is a fork: dragging it moves all lines that meet there.',
  draw: 'Draw on the skin. Drag beside the face to turn it.',
  smooth: 'Click a line, or drag over lines, to smooth them.',
  erase: 'Click a line, or drag over lines, to delete them.',
  bulge: 'A negative depth raises the skin: the line is a bulge.',
} as const

/** Returns the label of a chosen line: `Line of Brow, left`. @param group name of its region in the file. */
export function lineLabel(group: string | undefined): string {
  return group === undefined ? LINE.line : `Line of ${regionLabel(group)}`
}

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

/** Returns the description of a line's cross-section: `Cross-section: 0.50 mm deep`. @param depth millimetres. */
export function sectionLabel(label: string, depth: number, isRaised: boolean): string {
  return `${label}: ${Math.abs(depth).toFixed(2)} mm ${isRaised ? 'raised' : 'deep'}`
}
