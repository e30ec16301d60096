/** What the computations on the graphics card share. */
import type { TypedArray } from 'three'
import { Fn, If, instanceIndex, storage } from 'three/tsl'
import {
  type ComputeNode,
  type Node,
  StorageBufferAttribute,
  type StorageBufferNode,
  type WebGPURenderer,
} from 'three/webgpu'
import type { AnyRenderer } from '../renderer.ts'

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

/**
 * A pass with an invocation for each of `count` elements. Those beyond the last, of which a workgroup is full, do nothing: some versions
 * of three.js do not stop them, and what they wrote would land on the last element.
 */
export function passOver(count: number, body: (i: Node<'uint'>) => void): ComputeNode {
  return Fn(() => {
    const i = instanceIndex as Node<'uint'>
    If(i.lessThan(count), () => body(i))
  })().compute(count)
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
