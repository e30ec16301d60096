import type { Camera, Material, Mesh } from 'three'
import type { Face } from '../../runtime/face.ts'
import type { ShaderInputs } from '../material/shader-inputs.ts'
import type { MeshPlace } from '../mesh/mesh-place.ts'
import type { WrinkleMode } from '../options.ts'
import type { AnyRenderer } from '../renderer.ts'

/** Part of a face that relief needs. */
export interface RaisedFace {
  readonly isDisposed: boolean
  readonly mode: WrinkleMode
  readonly mesh: Mesh
  readonly meshes: readonly Mesh[]
  /** One face per instance. */
  readonly faces: readonly Face[]
  /** Place of the mesh when the wrinkles were added. */
  readonly place: MeshPlace
  readonly material: {
    /** Wrinkled material. */
    readonly material: Material
    /** Sets the patch that draws relief; null for none. */
    setRelief(patch: ((material: Material) => () => void) | null): void
  }
  readonly shaderInputs: ShaderInputs
  /** @throws FurrowError if the wrinkles were disposed of. */
  checkInUse(method: string): void
  /** Runs the phases of the frame, before a mesh is drawn. */
  prepare(renderer: AnyRenderer, camera: Camera, mesh: Mesh): void
}
