/** Casts of TSL nodes that three.js's declarations leave untyped. Casts for compute passes are in `compute/buffers.ts`. */
import type { Material } from 'three'
import { int, textureSize, uniform } from 'three/tsl'
import { MaterialReferenceNode, type Node, type TextureNode } from 'three/webgpu'
import { subBuild } from './newer-nodes.ts'

/** Node types by the type argument of `materialReference`. */
interface PropertyNodes {
  float: 'float'
  vec2: 'vec2'
  color: 'vec3'
  texture: 'vec4'
}

/**
 * Property of the material being drawn.
 *
 * @param owner fallback: the renderer's shadow material uses nodes of the mesh's material, but may lack its properties.
 */
export function materialProperty<T extends keyof PropertyNodes>(
  name: string,
  type: T,
  owner: Material,
): Node<PropertyNodes[T]> {
  return typed(new PropertyNode(name, type, owner))
}

class PropertyNode extends MaterialReferenceNode {
  readonly #owner: Material

  constructor(name: string, type: string, owner: Material) {
    super(name, type)
    this.#owner = owner
  }

  override updateReference(state: { material: Material | null }) {
    const { material } = state
    const isPresent = material && material[this.property as keyof Material] != null
    this.reference = isPresent ? material : this.#owner
    return this.reference
  }
}

/** Uniform that reads an input's `value` before each draw. */
export function inputUniform<T extends string>(input: { readonly value: unknown }, type?: T): Node<T> {
  return typed(uniform(input.value as never, type as never).onObjectUpdate(() => input.value))
}

/** Channels of a `vec4` in the order of the layers. */
export const CHANNELS = ['x', 'y', 'z', 'w'] as const

/** Width and height of a texture's level 0, texels. */
export function sizeOf(node: TextureNode): Node<'ivec2'> {
  return typed(textureSize(node, int(0)))
}

/** View-space normal, built like the material's own in three.js. */
export function normalInView(normal: Node): Node<'vec3'> {
  return typed(subBuild(normal, 'NORMAL', 'vec3'))
}

/** Declares the type of a node. */
export function typed<T extends string>(node: Node): Node<T> {
  return node as Node<T>
}

/** Scale of the material's normal map. */
export function normalScale(owner: Material): Node<'vec2'> {
  return materialProperty('normalScale', 'vec2', owner)
}
