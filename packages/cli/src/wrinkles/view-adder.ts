import type { Glb } from './glb-file.ts'

/** Puts data at the end of a file's binary part, so that no index of anything else changes. */
export class ViewAdder {
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

  /** @returns the index of a buffer view of the bytes. */
  add(bytes: Uint8Array): number {
    const gap = (4 - (this.#length % 4)) % 4
    this.#parts.push(Buffer.alloc(gap), bytes)
    const byteOffset = this.#length + gap
    this.#length = byteOffset + bytes.length
    return this.#glb.json.bufferViews!.push({ buffer: 0, byteOffset, byteLength: bytes.length }) - 1
  }

  /** Replaces the binary part by the longer one. */
  finish(): void {
    this.#glb.json.buffers![0].byteLength = this.#length
    this.#glb.bin = Buffer.concat(this.#parts)
  }
}
