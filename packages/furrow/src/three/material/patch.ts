import type { Mesh, Texture, WebGLRenderer } from 'three'
import type { Activations } from '../../runtime/activations.ts'
import type { AnyRenderer } from '../renderer.ts'
import type { ShaderInputs } from './shader-inputs.ts'
import type { WrinkleMaterial } from './wrinkle-material.ts'

/** The face that a mode is shown on, and the events of its shader's compilation. */
export interface ModeHost {
  readonly material: WrinkleMaterial
  readonly inputs: ShaderInputs
  /** The meshes of the face: a list that may grow. */
  readonly meshes: readonly Mesh[]
  /** The shader cannot be edited after all; it then stays as it was. */
  refuse(): void
  /** Called on `WebGLRenderer` when an edited shader is about to be compiled. `compile` calls nothing else that precedes a draw. */
  onCompile(renderer: WebGLRenderer): void
}

/** A change that makes a material show wrinkles. The caller has the material built again. */
export interface ShownMode {
  /** The material's own normal map, where another one is in its place. */
  base?: Texture
  /** The map in that place. */
  composed?: Texture
  /** Phase 5 of a frame: takes the activations of the face, when its influence map is up to date. */
  update?: (renderer: AnyRenderer, activations: Activations) => void
  /** Whether its shader is right for another mesh of the face; for any where it is left out. */
  isFor?(mesh: Mesh): boolean
  /** Whether its shader is right for the maps that the material has by now, and for the faces in the atlas; always where it is left out. */
  isCurrent?(): boolean
  undo(): void
}
