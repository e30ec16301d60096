import { type AddDrivers, bindDrivers, BINDINGS as WEBGL_BINDINGS } from '../sources/add-drivers.ts'
import type { InputBindings } from '../sources/binding.ts'
import { bindComputedTension } from './computed-tension.ts'

/** How `furrow/webgpu` reads each kind of input. */
export const BINDINGS: InputBindings = { ...WEBGL_BINDINGS, tension: bindComputedTension }

/**
 * Lets drivers activate areas, as `addDrivers` of furrow/three does, and measures tension in compute passes where the renderer
 * runs on WebGPU.
 *
 * @param drivers types that nobody here knows are left out with a warning, and so is what drivers name and the mesh does not
 *   have: targets, joints, areas.
 */
export const addDrivers: AddDrivers = (wrinkles, drivers, options = {}) => {
  bindDrivers(wrinkles, drivers, () => options, BINDINGS).bind()
}
