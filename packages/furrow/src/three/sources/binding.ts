import type { GLTF } from 'three/addons/loaders/GLTFLoader.js'
import type { InputOf } from '../../drivers/activation.ts'
import type { VrmExpressions } from '../../drivers/morph/vrm.ts'
import type { InputReader, MeasuredKind } from '../../runtime/driver-runtime.ts'
import type { AnyRenderer } from '../renderer.ts'
import type { WrinklesBase } from '../wrinkles-base.ts'

/** Options of `addDrivers`. */
export interface DriversOptions {
  /** A VRM's expressions (`vrm.expressionManager` of three-vrm), which links may name like blendshapes. */
  expressions?: VrmExpressions
}

/** Finds inputs of one kind on a mesh. */
export type BindInputs<K extends MeasuredKind> = (
  wrinkles: WrinklesBase,
  inputs: readonly InputOf<K>[],
  options: DriversOptions,
) => InputReader<AnyRenderer>

/** How a renderer reads each kind of input. Drivers that read others are left out. */
export type InputBindings = { readonly [K in MeasuredKind]?: BindInputs<K> }

/** How a renderer measures tension: fetched, since most files have no use for it. */
export type FetchTension = () => Promise<BindInputs<'tension'>>

/**
 * Lets the drivers of a file activate the areas of a face.
 *
 * @param file that the face was loaded from; none for copies. If it is a VRM, its expressions may not exist before its first frame.
 */
export type Drive = (own: WrinklesBase, file?: GLTF) => void
