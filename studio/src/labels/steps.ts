import { MAPS } from './layers.ts'
import { LINE } from './lines.ts'
import { regionLabel } from './names.ts'

/** Names of the steps that Undo takes back and Redo repeats. */
export const STEP = {
  sculpt: 'Sculpt',
  makeWrinkles: 'Make automatic wrinkles',
  addRegion: 'Add a region',
  addDriver: 'Add a driver',
  changeDriver: 'Change a driver',
  removeDriver: 'Remove a driver',
  addLayer: 'Add a layer',
  drawLine: 'Draw a line',
  detachLine: 'Detach a line',
  splitLine: 'Split a line',
  addPoint: 'Add a point',
  movePoint: 'Move a point',
  moveFork: 'Move a fork',
  removePoint: 'Remove a point',
  recordTake: 'Record a take',
  openRecording: 'Open a recording',
  renameTake: 'Rename a take',
  trimTake: 'Trim a take',
  deleteTake: 'Delete a take',
} as const

/** Returns the name of a step that changes one region. @param region its name in the file. */
export function regionStep(
  verb: 'Add' | 'Paint' | 'Duplicate' | 'Mirror' | 'Remove' | 'Rename' | 'Change',
  region: string,
): string {
  return `${verb} ${regionLabel(region)}`
}

export function fillFromImageStep(region: string): string {
  return `Fill ${regionLabel(region)} from an image`
}

export function fillWithLinesStep(region: string): string {
  return `Fill ${regionLabel(region)} with lines`
}

export function recordPoseStep(region: string): string {
  return `Record the pose of ${regionLabel(region)}`
}

/** Returns the name of the step after which regions only show in a pose. */
export function showInPoseStep(regions: readonly string[]): string {
  return `Show ${regions.map(regionLabel).join(' and ')} in a pose`
}

/** @param size width and height of the regions, texels. */
export function resizeRegionsStep(size: number): string {
  return `Change the size of regions to ${size}`
}

/** Returns the name of a step that changes one layer. */
export function layerStep(verb: 'Remove' | 'Rename' | 'Move' | 'Change', layer: string): string {
  return `${verb} ${layer}`
}

/** Returns the name of a step that changes a map of a layer: `Import height of forehead`. */
export function mapStep(verb: 'Import' | 'Remove', map: keyof typeof MAPS, layer: string): string {
  return `${verb} ${MAPS[map].toLowerCase()} of ${layer}`
}

export function resetSculptingStep(layer: string): string {
  return `Reset sculpting of ${layer}`
}

/** @param file name of the file of the sculpt. */
export function bakeStep(file: string): string {
  return `Bake ${file}`
}

/** @param target name of the blendshape in the file. */
export function correctShapeStep(target: string): string {
  return `Correct ${target}`
}

/** Returns the name of a step that changes whole lines: `Remove 3 lines`. */
export function linesStep(verb: 'Remove' | 'Smooth' | 'Mirror', count: number): string {
  return `${verb} ${linesNoun(count)}`
}

/** Returns the name of a step that changes fields of lines: `Change the depth of 3 lines`. */
export function lineFieldsStep(fields: readonly (keyof typeof LINE_FIELDS)[], count: number): string {
  return `Change the ${fields.map((field) => LINE_FIELDS[field]).join(' and ')} of ${linesNoun(count)}`
}

const LINE_FIELDS = {
  width: 'width',
  depth: 'depth',
  softness: lowered(LINE.softness),
  shoulder: lowered(LINE.shoulder),
  bank: 'edge distance',
  lean: lowered(LINE.lean),
  taper: lowered(LINE.taper),
  group: lowered(LINE.group),
  layer: lowered(LINE.layer),
} as const

function lowered(label: string): string {
  return label.toLowerCase()
}

function linesNoun(count: number): string {
  return count > 1 ? `${count} lines` : 'a line'
}
