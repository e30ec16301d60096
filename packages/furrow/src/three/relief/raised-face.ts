import type { Camera, Material, Mesh } from 'three'
import type { Face } from '../../runtime/face.ts'
import type { ShaderInputs } from '../material/shader-inputs.ts'
import type { MeshPlace } from '../mesh/mesh-place.ts'
import type { WrinkleMode } from '../options.ts'
import type { AnyRenderer } from '../renderer.ts'

/** Properties of a face that relief needs. Relief displaces the surface by height maps. */
export interface RaisedFace {
  readonly isDisposed: boolean
  readonly mode: WrinkleMode
  readonly mesh: Mesh
  readonly meshes: readonly Mesh[]
  /** One face per instance. */
  readonly faces: readonly Face[]
  /** World matrices of the mesh when the wrinkles were added. */
  readonly place: MeshPlace
  readonly material: {
    readonly material: Material
    /** Sets the patch that draws relief; null removes it. */
    setRelief(patch: ((material: Material) => () => void) | null): void
  }
  readonly shaderInputs: ShaderInputs
  /** @throws FurrowError if the wrinkles were disposed of. */
  checkInUse(method: string): void
  /** Runs the phases of the frame, before a mesh is drawn. */
  prepare(renderer: AnyRenderer, camera: Camera, mesh: Mesh): void
}
