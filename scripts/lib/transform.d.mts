import type { Transform } from '@gltf-transform/core'

export function shrinking(lossless: boolean): Transform[]
export function transformFile(input: string, output: string, transforms: Transform[]): Promise<void>
