import type { DriverDefinition } from '../definition.ts'

/**
 * Driver for two blendshapes that cancel each other, such as raising and lowering the same brow. The smaller of their two weights is
 * subtracted from both before other drivers read the weights. The weights of the mesh do not change.
 */
export interface ConflictDriver {
  type: 'conflict'
  /** Names of the two blendshapes. */
  targets: [string, string]
}

export const conflict: DriverDefinition<ConflictDriver> = {
  type: 'conflict',
  read: (fields) => ({ targets: fields.names('targets') }),
  describe: ({ targets }) => `conflict: ${targets.join(' and ')} cancel each other`,
  filterInputs: ({ targets }) => ({
    inputs: targets.map((name) => ({ kind: 'target', name })),
    bind:
      ([a, b]) =>
      (values) => {
        let weightA = 0
        let weightB = 0
        for (let k = 0; k < a.length; k++) weightA += values[a[k]] / a.length
        for (let k = 0; k < b.length; k++) weightB += values[b[k]] / b.length
        const common = Math.min(weightA, weightB)
        if (!(common > 0)) return
        for (let k = 0; k < a.length; k++) values[a[k]] -= common
        for (let k = 0; k < b.length; k++) values[b[k]] -= common
      },
  }),
}
