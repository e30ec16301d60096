/** What the computations on the graphics card share. */
import type { TypedArray } from 'three'
import { storage } from 'three/tsl'
import { type Node, StorageBufferAttribute, type StorageBufferNode, type WebGPURenderer } from 'three/webgpu'
import type { AnyRenderer } from '../three/influence-atlas.ts'

const SIZES = { float: 1, uint: 1, vec2: 2, vec4: 4, uvec4: 4, mat4: 16 } as const
type BufferType = keyof typeof SIZES

/** Storage buffers of one computation, freed together. */
export class Buffers {
  readonly #attributes: StorageBufferAttribute[] = []

  /** @param values what it holds at first; kept, not copied. */
  create<T extends BufferType>(type: T, values: TypedArray): StorageBufferNode<T> {
    const attribute = new StorageBufferAttribute(values, SIZES[type])
    this.#attributes.push(attribute)
    return storage(attribute, type, attribute.count) as StorageBufferNode<T>
  }

  dispose(): void {
    // Older three.js has no way to free one, and leaves it to the renderer's end.
    for (const attribute of this.#attributes) attribute.dispose?.()
  }
}

/** One of a buffer's elements, as the types of TSL leave it out. */
export function at<T>(buffer: StorageBufferNode<T>, index: Node): Node<T> {
  return buffer.element(index) as unknown as Node<T>
}

/** Whether a renderer can compute with storage buffers: on WebGPU, not on its WebGL 2 backend. */
export function canCompute(renderer: AnyRenderer): renderer is WebGPURenderer {
  const { backend } = renderer as WebGPURenderer & { backend?: { isWebGPUBackend?: boolean } }
  return backend?.isWebGPUBackend === true
}

/** Sets x, y and z of each element, four numbers apart as storage buffers have them. */
export function padded(
  values: ArrayLike<number>,
  out = new Float32Array((4 * values.length) / 3),
): Float32Array {
  for (let i = 0; i < values.length; i++) out[4 * Math.floor(i / 3) + (i % 3)] = values[i]
  return out
}

/** Lists of numbers one after the other, and where each of them starts, and the last ends. */
export function joinLists(lists: readonly (readonly number[])[]): { starts: Uint32Array; joined: number[] } {
  const starts = new Uint32Array(lists.length + 1)
  for (let i = 0; i < lists.length; i++) starts[i + 1] = starts[i] + lists[i].length
  return { starts, joined: lists.flat() }
}
