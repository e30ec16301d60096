import type { AreaActivation, Input } from './activation.ts'
import type { Fields } from './fields.ts'

/** Changes inputs before drivers read them. */
export interface InputFilter {
  /** Inputs that the filter reads or changes. If the model lacks one of them, the filter is skipped. */
  inputs: readonly Input[]
  /**
   * Creates the filter function. Called once per mesh.
   *
   * @param indices for each input, the indices of its values. The input is the mean of these values.
   * @returns a function that changes values in place. It runs once per face and frame, and should not allocate.
   */
  bind(indices: readonly Uint16Array[]): (values: Float64Array) => void
}

/** Changes the activation of an area after all drivers have added to it. The change may depend on the previous frame. */
export interface ActivationFilter {
  /** Name of the area. */
  area: string
  /**
   * Creates the filter function. Called once per mesh.
   *
   * @param index index of the area.
   * @returns a function that changes `activations[index]`. `previous[index]` contains the result of the previous frame, and the function
   *   must store its result there. `seconds[0]` is the time since the previous frame. The function runs once per face and frame, and should
   *   not allocate.
   */
  bind(index: number): (activations: Float32Array, previous: Float64Array, seconds: Float64Array) => void
}

/**
 * Definition of a driver type: how its JSON is read, and how its drivers are evaluated. A driver can activate an area (a group of wrinkles),
 * filter inputs, filter an activation, or only store data for other code.
 *
 * @typeParam D type of the driver object.
 */
export interface DriverDefinition<D extends { type: string } = { type: string }> {
  /** Value of the JSON field `type`. */
  readonly type: D['type']
  /** Reads a driver from JSON. The methods of `fields` throw FurrowError. */
  read(fields: Fields): Omit<D, 'type'>
  /** Describes the driver in one line. By default, the description is a formula of the driver's links, or a list of its fields. */
  describe?(driver: D): string
  /** Returns how the driver activates an area, if it does. Called once per mesh. */
  activate?(driver: D): AreaActivation | undefined
  /** Returns the driver's filter of inputs. Called once per mesh. */
  filterInputs?(driver: D): InputFilter
  /** Returns the driver's filter of an activation. Called once per mesh. If several drivers filter one area, only the last filter runs. */
  filterActivation?(driver: D): ActivationFilter
}
