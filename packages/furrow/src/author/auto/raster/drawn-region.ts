import type { MorphDriver } from '../../../drivers/morph/definition.ts'
import type { CreasedRegion } from '../lines/crease.ts'

/** Region whose lines and area are drawn. */
export interface DrawnRegion extends CreasedRegion {
  /** Driver that reads blendshapes; undefined if joints activate the area. */
  driver?: MorphDriver
}
