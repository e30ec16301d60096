export interface Measured {
  version: string
  webgl2: boolean
  webgpu: boolean
  auto: boolean
  studio: boolean
}

/** The lines of the table of what was measured in each browser. */
export function browserTable(measured: Record<string, Measured>): string[]
export function readMeasured(): Record<string, Measured>
