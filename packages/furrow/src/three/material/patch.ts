import type { Mesh, Texture, WebGLRenderer } from 'three'
import type { Activations } from '../../runtime/activations.ts'
import type { AnyRenderer } from '../renderer.ts'

/** What a patched material is called and asked when its shader is compiled. */
export interface PatchEvents {
  /** The shader cannot be edited after all; it then stays as it was. */
  refuse(): void
  /** On `WebGLRenderer`, which in `compile` does nothing else that is done before a mesh is drawn. */
  onCompile(renderer: WebGLRenderer): void
}

/** What makes a material show wrinkles. Whoever changes it has the material built anew. */
export interface ShownMode {
  /** The material's own normal map, where another one is in its place. */
  base?: Texture
  /** That one. */
  composed?: Texture
  /** Phase 5 of a frame: takes the activations of the face, when its influence map is up to date. */
  update?: (renderer: AnyRenderer, activations: Activations) => void
  /** Whether its shader is right for another mesh of the face; for any where it is left out. */
  isFor?(mesh: Mesh): boolean
  /** Whether its shader is right for the maps that the material has by now; always where it is left out. */
  isCurrent?(): boolean
  undo(): void
}
