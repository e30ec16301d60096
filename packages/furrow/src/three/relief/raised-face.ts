import type { Camera, Material, Mesh } from 'three'
import type { Face } from '../../runtime/face.ts'
import type { ShaderInputs } from '../material/shader-inputs.ts'
import type { MeshPlace } from '../mesh/mesh-place.ts'
import type { WrinkleMode } from '../options.ts'
import type { AnyRenderer } from '../renderer.ts'

/** A face whose surface may be moved: what relief needs of its wrinkles. */
export interface RaisedFace {
  readonly isDisposed: boolean
  readonly mode: WrinkleMode
  readonly mesh: Mesh
  /** All meshes of the face. */
  readonly meshes: readonly Mesh[]
  /** One per instance. */
  readonly faces: readonly Face[]
  /** Where the mesh was when the wrinkles were added. */
  readonly place: MeshPlace
  readonly material: {
    /** Shows the wrinkles. */
    readonly material: Material
    /** Makes the material draw relief too; null for none. */
    setRelief(patch: ((own: Material) => () => void) | null): void
  }
  readonly shaderInputs: ShaderInputs
  /** @throws FurrowError when the wrinkles were disposed of. */
  checkInUse(method: string): void
  /** Called before a mesh is drawn. Runs the phases of the frame. */
  prepare(renderer: AnyRenderer, camera: Camera, mesh: Mesh): void
}
