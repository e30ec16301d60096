/** TSL nodes whose type three.js's declarations leave open. All casts of nodes are in this file, but those of compute passes. */
import type { Material } from 'three'
import { int, textureSize, uniform } from 'three/tsl'
import { MaterialReferenceNode, type Node, type TextureNode } from 'three/webgpu'
import { subBuild } from './newer-nodes.ts'

/** Materials' properties by the type that `materialReference` takes, and what their nodes are. */
interface PropertyNodes {
  float: 'float'
  vec2: 'vec2'
  color: 'vec3'
  texture: 'vec4'
}

/**
 * A property of the material being drawn.
 *
 * @param owner material that the node is made for. Shadows are drawn by a material of the renderer's own with nodes of the mesh's: it has not
 *   all of their properties, and the renderer fails on those.
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
    const isThere = material && material[this.property as keyof Material] != null
    this.reference = isThere ? material : this.#owner
    return this.reference
  }
}

/** A uniform that takes an input's `value` whenever an object is drawn. */
export function inputUniform<T extends string>(input: { readonly value: unknown }, type?: T): Node<T> {
  return typed(uniform(input.value as never, type as never).onObjectUpdate(() => input.value))
}

/** Channels of a `vec4` in the order of the layers. */
export const CHANNELS = ['x', 'y', 'z', 'w'] as const

/** Width and height of a texture's level 0, in texels. */
export function sizeOf(node: TextureNode): Node<'ivec2'> {
  return typed(textureSize(node, int(0)))
}

/** A normal in view space, built as three.js builds the material's own. */
export function normalInView(normal: Node): Node<'vec3'> {
  return typed(subBuild(normal, 'NORMAL', 'vec3'))
}

/** Declares the type of a node. */
export function typed<T extends string>(node: Node): Node<T> {
  return node as Node<T>
}

/** The scale of the material's normal map. */
export function normalScale(owner: Material): Node<'vec2'> {
  return materialProperty('normalScale', 'vec2', owner)
}
