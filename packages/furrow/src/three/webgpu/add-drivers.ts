import { type AddDrivers, addDriversBy } from '../sources/add-drivers.ts'
import { BINDINGS } from './bindings.ts'

/**
 * Lets drivers activate areas, as `addDrivers` of furrow/three does, but measures tension in compute passes if the renderer runs on
 * WebGPU.
 *
 * @param wrinkles of the face.
 * @param drivers as in a file. Unknown types are left out with a warning, as are targets, joints and areas that do not exist.
 * @param options a VRM's expressions.
 */
export const addDrivers: AddDrivers = addDriversBy(BINDINGS)
