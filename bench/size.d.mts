import type { Size } from '../scripts/lib/download.mjs'

interface Chunk {
  fileName: string
  imports: string[]
  code: string
}

export function measureSizes(): Promise<Record<string, Size>>
export function measurePeers(): Promise<Record<string, Size>>
export function measureFloor(): Promise<Record<string, Size>>
export function bundle(code: string, external: RegExp): Promise<Chunk[]>
export function closure(chunks: readonly Chunk[], all: readonly Chunk[]): Chunk[]
export function compressed(chunks: readonly { code: string }[]): Size
