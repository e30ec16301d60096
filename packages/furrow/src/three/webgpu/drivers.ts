import { type AddDrivers, playDrivers } from '../drivers.ts'
import { computedTension } from './computed-tension.ts'

/**
 * Lets a file's drivers move wrinkles, as `addDrivers` of furrow/three does, and measures tension on the graphics card where the
 * renderer runs on WebGPU.
 *
 * @param drivers types this version does not know are left out with a warning, and so is what they name and the mesh does not
 *   have: targets, joints, areas.
 */
export const addDrivers: AddDrivers = (wrinkles, drivers, options = {}) =>
  playDrivers(wrinkles, drivers, options, computedTension)
