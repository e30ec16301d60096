/** Functions that create compute passes and their buffers. Some functions only add types that three.js's declarations lack. */
import type { TypedArray } from 'three'
import { Fn, If, instanceIndex, storage } from 'three/tsl'
import {
  type ComputeNode,
  type Node,
  StorageBufferAttribute,
  type StorageBufferNode,
  type WebGPURenderer,
} from 'three/webgpu'
import type { AnyRenderer } from '../../renderer.ts'
import { workgroupArray } from '../newer-nodes.ts'

const SIZES = { float: 1, uint: 1, vec2: 2, vec4: 4, uvec4: 4, mat4: 16 } as const
type BufferType = keyof typeof SIZES

/** Storage buffers that are disposed of together. */
export class Buffers {
  readonly #attributes: StorageBufferAttribute[] = []

  /** @param values initial contents. The buffer keeps a reference to the array. */
  create<T extends BufferType>(type: T, values: TypedArray): StorageBufferNode<T> {
    const attribute = new StorageBufferAttribute(values, SIZES[type])
    this.#attributes.push(attribute)
    return storage(attribute, type, attribute.count)
  }

  dispose(): void {
    // three.js r186 ignores this, and frees storage buffers only when the renderer is disposed of.
    for (const attribute of this.#attributes) attribute.dispose()
  }
}

/**
 * Creates a compute pass with one invocation per element. The last workgroup may have invocations beyond the last element, and some three.js
 * releases run them. Without the `If`, these invocations would overwrite the last element, because out-of-bounds indices are clamped.
 */
export function computePass(count: number, body: (i: Node<'uint'>) => void): ComputeNode {
  return Fn(() => {
    If(instanceIndex.lessThan(count), () => body(instanceIndex))
  })().compute(count)
}

/** Whether a renderer supports compute passes with storage buffers: `WebGPURenderer` with its WebGPU backend. */
export function canCompute(renderer: AnyRenderer): renderer is WebGPURenderer {
  const { backend } = renderer as WebGPURenderer & { backend?: { isWebGPUBackend?: boolean } }
  return backend?.isWebGPUBackend === true
}

/** Pads packed xyz values to four numbers each, because storage buffers align a `vec3` to 16 bytes (WGSL, "Alignment and Size"). */
export function padToVec4(
  values: ArrayLike<number>,
  out = new Float32Array((4 * values.length) / 3),
): Float32Array {
  for (let i = 0; i < values.length; i++) out[4 * Math.floor(i / 3) + (i % 3)] = values[i]
  return out
}

/** Creates an array in workgroup memory. */
export function sharedArray<T extends string>(type: T, count: number): StorageBufferNode<T> {
  return typedBuffer(workgroupArray(type, count))
}

/** Returns the dispatch size for a number of workgroups. The result is cast, because three.js's types allow only a number of invocations. */
export function workgroups(count: number): number {
  return [count, 1, 1] as unknown as number
}

/** Declares the type of a buffer's elements. */
export function typedBuffer<T extends string>(node: Node): StorageBufferNode<T> {
  return node as StorageBufferNode<T>
}
