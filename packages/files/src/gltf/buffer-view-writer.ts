import { concat } from '../base/bytes.ts'
import type { Glb } from './glb.ts'

/** Appends data to the binary chunk of a glTF file as new buffer views. Existing buffer views do not change. */
export class BufferViewWriter {
  readonly #glb: Glb
  readonly #parts: Uint8Array[]
  #length: number

  constructor(glb: Glb) {
    this.#glb = glb
    this.#parts = [glb.bin]
    this.#length = glb.bin.length
    glb.json.bufferViews ??= []
    glb.json.buffers ??= []
    glb.json.buffers[0] ??= { byteLength: 0 }
  }

  /** @returns index of the new buffer view. */
  add(bytes: Uint8Array): number {
    const gap = (4 - (this.#length % 4)) % 4
    this.#parts.push(new Uint8Array(gap), bytes)
    const byteOffset = this.#length + gap
    this.#length = byteOffset + bytes.length
    return this.#glb.json.bufferViews!.push({ buffer: 0, byteOffset, byteLength: bytes.length }) - 1
  }

  /** Replaces the binary chunk. Call it once, after the last `add`. */
  finish(): void {
    this.#glb.json.buffers![0].byteLength = this.#length
    this.#glb.bin = concat(this.#parts)
  }
}
