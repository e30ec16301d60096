export interface Measured {
  version: string
  webgl2: boolean
  webgpu: boolean
  auto: boolean
  studio: boolean
}

export function browserTable(measured: Record<string, Measured>): string[]
export function readMeasured(): Record<string, Measured>
