import type { Size } from '../scripts/lib/download.mjs'

interface Chunk {
  fileName: string
  imports: string[]
  dynamicImports?: string[]
  code: string
}

export function measureSizes(): Promise<Record<string, Size>>
export function closure(
  chunks: readonly Chunk[],
  all: readonly Chunk[],
  kinds?: readonly ('imports' | 'dynamicImports')[],
): Chunk[]
export function compressed(chunks: readonly { code: string }[]): Size
