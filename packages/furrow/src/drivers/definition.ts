import type { AreaActivation, Input } from './activation.ts'
import type { Fields } from './fields.ts'

/** Changes inputs before any driver reads them. */
export interface InputFilter {
  /** Inputs to read or change. If the model lacks one, the filter is skipped. */
  inputs: readonly Input[]
  /**
   * Resolves the inputs, once per mesh.
   *
   * @param indices per input: indices of values; the input is their mean.
   * @returns a function that changes the values in place. Runs once per face and frame, and should not allocate.
   */
  bind(indices: readonly Uint16Array[]): (values: Float64Array) => void
}

/** Changes an area's activation after all drivers have run. The change may depend on the previous frame. */
export interface ActivationFilter {
  /** Name of the area. */
  area: string
  /**
   * Resolves the area, once per mesh.
   *
   * @param index index of the area.
   * @returns a function that reads and writes `activations[index]` and `previous[index]`, the result of the previous frame. `seconds[0]`
   *   is the time since then. Runs once per face and frame, and should not allocate.
   */
  bind(index: number): (activations: Float32Array, previous: Float64Array, seconds: Float64Array) => void
}

/**
 * JSON and evaluation of one driver type. A driver activates an area, filters inputs, filters an activation, or is data for other code.
 *
 * @typeParam D driver as read from a file.
 */
export interface DriverDefinition<D extends { type: string } = { type: string }> {
  /** `type` of the driver in files. */
  readonly type: D['type']
  /** Reads a driver from JSON. The methods of `fields` throw FurrowError. */
  read(fields: Fields): Omit<D, 'type'>
  /** Describes the driver in one line. Default: its activation, or its fields. */
  describe?(driver: D): string
  /** Returns the contribution to an area, if any. Called once per mesh. */
  activate?(driver: D): AreaActivation | undefined
  /** Returns the filter of inputs. Called once per mesh. */
  filterInputs?(driver: D): InputFilter
  /** Returns the filter of an activation. Called once per mesh. With several for one area, the last one counts. */
  filterActivation?(driver: D): ActivationFilter
}
