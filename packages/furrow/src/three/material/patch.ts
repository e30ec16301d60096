import type { Mesh, Texture, WebGLRenderer } from 'three'
import type { Activations } from '../../runtime/activations.ts'
import type { AnyRenderer } from '../renderer.ts'
import type { ShaderInputs } from './shader-inputs.ts'
import type { WrinkleMaterial } from './wrinkle-material.ts'

/** Face whose material a mode patches, with callbacks for the compilation of its shader. */
export interface ModeHost {
  readonly material: WrinkleMaterial
  readonly inputs: ShaderInputs
  /** Live list of the face's meshes. */
  readonly meshes: readonly Mesh[]
  /** Reports that the shader cannot be patched, and was left unchanged. */
  refuse(): void
  /** Called before `WebGLRenderer` compiles a patched shader: the only callback that `WebGLRenderer.compile` triggers. */
  onCompile(renderer: WebGLRenderer): void
}

/** A patch that makes a material show wrinkles. Callers must rebuild the material. */
export interface ShownMode {
  /** The material's original normal map, if the mode replaces it. */
  base?: Texture
  /** The replacement of `base`. */
  composed?: Texture
  /** Phase 5 of a frame, with an up-to-date influence map. */
  update?: (renderer: AnyRenderer, activations: Activations) => void
  /** Whether the shader supports another mesh of the face. Omitted if it supports any. */
  supportsMesh?(mesh: Mesh): boolean
  /** Whether the shader matches the material's current maps and the faces in the atlas. Omitted if it always does. */
  isCurrent?(): boolean
  undo(): void
}
