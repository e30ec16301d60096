import { regionLabel } from './names.ts'
import { bytesLabel } from './project.ts'
import { fillFromImageStep } from './steps.ts'

/** Fields and commands of a region, which the file calls an area. */
export const REGION = {
  name: 'Name in the file',
  layer: 'Layer',
  overlap: 'Overlap',
  rest: 'Always visible',
  record: 'Show it in this pose',
  recordHint: 'Replaces the blendshapes that show it now',
  duplicate: 'Duplicate',
  mirror: 'Copy to the other side',
  fromImage: 'From image…',
  remove: 'Delete',
  add: 'New region',
  addImage: 'Add from image…',
  paper: 'White = no wrinkles',
  size: 'Region size',
  reset: 'Reset',
  resetAll: 'Reset all regions',
  select: 'Select',
  removeRow: 'Remove',
  soloHint: 'Show only this region',
  hideHint: 'Show the face without this region',
  imageHint:
    "Or drop a gray image anywhere. In the paper's convention black shows wrinkles; clear the box if white does.",
  mirrorHint: 'Add or replace the mirror image of this region',
  overlapHint: 'How this region combines with other regions of its layer',
  added: 'Added',
  maximum: 'Maximum',
  fromImageHint: 'Replace the painted weights by a gray image',
} as const

/** Returns the accessible names of a region's controls. @param name name in the file. */
export function regionLabels(name: string) {
  return {
    remove: `Remove region ${name}`,
    select: `Select ${regionLabel(name)} ${name}`,
    solo: `Solo ${name}`,
    hide: `Hide ${name}`,
    fromImage: fillFromImageStep(name),
  }
}

/** Returns the label of a square map's size: `128 x 128`. */
export function sizeLabel(size: number): string {
  return `${size} x ${size}`
}

/** Returns the sentences about the GPU memory of regions, bytes, and the most texels that a frame writes. */
export function regionCostLabel({ bytes, texels }: { bytes: number; texels: number }): string {
  return `Regions take ${bytesLabel(bytes)} on the GPU. When they change, a frame updates at most ${texels.toLocaleString('en')} of their texels.`
}
