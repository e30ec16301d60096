import type { Transform } from '@gltf-transform/core'

export function compressing(lossless: boolean): Transform[]
export function transformFile(input: string, output: string, transforms: Transform[]): Promise<void>
