/** Typed versions of TSL functions whose nodes have no type in three.js's declarations. For compute passes see `compute/buffers.ts`. */
import type { Material } from 'three'
import { int, textureSize, uniform } from 'three/tsl'
import { MaterialReferenceNode, type Node, type TextureNode } from 'three/webgpu'
import { subBuild } from './newer-nodes.ts'

/** Maps each property type of three.js' `MaterialReferenceNode` to the TSL type of the node's value. */
interface PropertyNodes {
  float: 'float'
  vec2: 'vec2'
  color: 'vec3'
  texture: 'vec4'
}

/**
 * Returns a node that reads a property of the material that is drawn.
 *
 * @param owner material that is read if the drawn material does not have the property. The renderer's shadow material uses the nodes of a
 *   mesh's material, but may not have the properties of that material.
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

/** Creates a uniform that reads `value` of an input before each draw. */
export function inputUniform<T extends string>(input: { readonly value: unknown }, type?: T): Node<T> {
  return typed(uniform(input.value as never, type as never).onObjectUpdate(() => input.value))
}

/** Channels of a `vec4`. If a vector holds one value per layer, the value of layer i is in the channel `CHANNELS[i]`. */
export const CHANNELS = ['x', 'y', 'z', 'w'] as const

/** Returns the width and height of a texture's finest mipmap level, texels. */
export function sizeOf(node: TextureNode): Node<'ivec2'> {
  return typed(textureSize(node, int(0)))
}

/**
 * Builds a view-space normal in the sub-build `NORMAL` of three.js, in which `normalView` is the normal of the geometry. Elsewhere,
 * `normalView` is the normal of the material.
 */
export function normalInView(normal: Node): Node<'vec3'> {
  return typed(subBuild(normal, 'NORMAL', 'vec3'))
}

/** Declares the type of a node. */
export function typed<T extends string>(node: Node): Node<T> {
  return node as Node<T>
}

export function normalScale(owner: Material): Node<'vec2'> {
  return materialProperty('normalScale', 'vec2', owner)
}
