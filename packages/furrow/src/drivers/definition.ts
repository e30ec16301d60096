import type { AreaActivation, Input } from './activation.ts'
import type { Fields } from './fields.ts'

/** Changes inputs before any driver reads them. */
export interface InputFilter {
  inputs: readonly Input[]
  /**
   * @param indices per input: where its values are; it is their mean.
   * @returns a function that changes the values in place. It runs once per face and frame and should not allocate.
   */
  bind(indices: readonly Uint16Array[]): (values: Float64Array) => void
}

/** Changes an area's activation after all drivers have run, with memory of the frame before. */
export interface ActivationFilter {
  area: string
  /**
   * @param index of the area.
   * @returns a function that reads and writes `activations[index]` and `previous[index]`, the result of the last frame;
   *   `seconds[0]` is the time since then. It runs once per face and frame and should not allocate.
   */
  bind(index: number): (activations: Float32Array, previous: Float64Array, seconds: Float64Array) => void
}

/**
 * All that a type of driver is. Its JSON Schema is `schema.json` in the same folder. A driver activates an area, filters
 * inputs, filters an activation, or does none of these and is data for somebody else.
 */
export interface DriverDefinition<D extends { type: string } = { type: string }> {
  readonly type: D['type']
  /** Reads the fields from JSON; throws FurrowError by `fields` where one is wrong. */
  read(fields: Fields): Omit<D, 'type'>
  /** One line for people. */
  describe(driver: D): string
  activate?(driver: D): AreaActivation | undefined
  filterInputs?(driver: D): InputFilter
  filterActivation?(driver: D): ActivationFilter
}
