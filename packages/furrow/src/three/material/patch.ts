import type { Mesh, Texture, WebGLRenderer } from 'three'
import type { Activations } from '../../runtime/activations.ts'
import type { AnyRenderer } from '../renderer.ts'
import type { ShaderInputs } from './shader-inputs.ts'
import type { WrinkleMaterial } from './wrinkle-material.ts'

/** A material to patch, the face that it belongs to, and callbacks for the compilation of its shader. */
export interface ModeHost {
  readonly material: WrinkleMaterial
  readonly inputs: ShaderInputs
  /** Meshes of the face. The list may grow. */
  readonly meshes: readonly Mesh[]
  /** Called if the shader cannot be patched. The shader is then unchanged. */
  refuse(): void
  /** Called before `WebGLRenderer` compiles the patched shader. */
  onCompile(renderer: WebGLRenderer): void
}

/** A patch that makes a material show wrinkles. After applying or undoing a patch, the caller must make the renderer rebuild the shader. */
export interface ShownMode {
  /** Original normal map of the material, if the mode replaces it. */
  base?: Texture
  /** Normal map that replaces `base`. */
  composed?: Texture
  /** Updates textures that depend on the influence map or the activations. Called in every frame, after the influence map is drawn. */
  update?: (renderer: AnyRenderer, activations: Activations) => void
  /** Whether the shader can draw another mesh of the face. Omitted if it can draw all meshes. */
  supportsMesh?(mesh: Mesh): boolean
  /** Whether the shader still matches the maps of the material and the number of faces in the atlas. Omitted if it always matches. */
  isCurrent?(): boolean
  undo(): void
}
