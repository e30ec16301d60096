import { type AddDrivers, addDriversBy } from '../sources/add-drivers.ts'
import { BINDINGS } from './bindings.ts'

/**
 * Lets drivers activate areas, as `addDrivers` of furrow/three does, and measures tension in compute passes where the renderer
 * runs on WebGPU.
 *
 * @param drivers types that nobody here knows are left out with a warning, and so is what drivers name and the mesh does not
 *   have: targets, joints, areas.
 */
export const addDrivers: AddDrivers = addDriversBy(BINDINGS)
