import type { DriverDefinition } from '../definition.ts'

/**
 * Two blendshapes that undo each other, as raising and lowering one brow: what both have is subtracted from both, before
 * any driver reads them. The mesh itself moves as it did.
 */
export interface ConflictDriver {
  type: 'conflict'
  targets: [string, string]
}

export const conflict: DriverDefinition<ConflictDriver> = {
  type: 'conflict',
  read: (fields) => ({ targets: fields.names('targets') }),
  describe: ({ targets }) => `${targets.join(' and ')} cancel`,
  filterInputs: ({ targets }) => ({
    inputs: targets.map((name) => ({ kind: 'target', name })),
    bind:
      ([a, b]) =>
      (values) => {
        let ofA = 0
        let ofB = 0
        for (let k = 0; k < a.length; k++) ofA += values[a[k]] / a.length
        for (let k = 0; k < b.length; k++) ofB += values[b[k]] / b.length
        const both = Math.min(ofA, ofB)
        if (!(both > 0)) return
        for (let k = 0; k < a.length; k++) values[a[k]] -= both
        for (let k = 0; k < b.length; k++) values[b[k]] -= both
      },
  }),
}
