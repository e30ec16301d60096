import type { AreaActivation, Input } from './activation.ts'
import type { Fields } from './fields.ts'

/** Changes inputs before any driver reads them. */
export interface InputFilter {
  /** The inputs that it reads or changes; where the model lacks one, it is left out. */
  inputs: readonly Input[]
  /**
   * Resolves the inputs, once per mesh.
   *
   * @param indices per input: indices of its values, whose mean it is.
   * @returns a function that changes the values in place. It runs once per face and frame and should not allocate.
   */
  bind(indices: readonly Uint16Array[]): (values: Float64Array) => void
}

/** Changes an area's activation after all drivers have run; it may depend on the frame before. */
export interface ActivationFilter {
  /** Name of the area. */
  area: string
  /**
   * Resolves the area, once per mesh.
   *
   * @param index of the area.
   * @returns a function that reads and writes `activations[index]` and `previous[index]`, the result of the last frame;
   *   `seconds[0]` is the time since then. It runs once per face and frame and should not allocate.
   */
  bind(index: number): (activations: Float32Array, previous: Float64Array, seconds: Float64Array) => void
}

/**
 * Everything about one type of driver: its JSON, and how it is evaluated. A driver activates an area, filters inputs, filters
 * an activation, or does none of these and is data for other code.
 *
 * @typeParam D the driver as read from a file.
 */
export interface DriverDefinition<D extends { type: string } = { type: string }> {
  /** Its `type` in files. */
  readonly type: D['type']
  /** Reads a driver from JSON. The methods of `fields` throw FurrowError. */
  read(fields: Fields): Omit<D, 'type'>
  /** What it does, in one line; without it, a driver that activates no area is described by its fields. */
  describe?(driver: D): string
  /** What it adds to an area, if anything. Called once per mesh, not per frame. */
  activate?(driver: D): AreaActivation | undefined
  /** How it changes inputs. Called once per mesh. */
  filterInputs?(driver: D): InputFilter
  /** How it changes an activation. Called once per mesh. Of several for one area the last counts. */
  filterActivation?(driver: D): ActivationFilter
}
