import type { Command } from 'commander'

/** Commands by name, loaded on first use. */
const COMMANDS = {
  activations: async () => (await import('../packages/cli/src/commands/activations.ts')).activationsCommand,
  array: async () => (await import('../packages/cli/src/commands/array.ts')).arrayCommand,
  auto: async () => (await import('../packages/cli/src/commands/auto.ts')).autoCommand,
  bake: async () => (await import('../packages/cli/src/commands/bake.ts')).bakeCommand,
  batch: async () => (await import('../packages/cli/src/batch/commands/batch.ts')).batchCommand,
  import: async () => (await import('../packages/cli/src/commands/import.ts')).importCommand,
  inspect: async () => (await import('../packages/cli/src/commands/inspect.ts')).inspectCommand,
  live: async () => (await import('../packages/cli/src/commands/live.ts')).liveCommand,
  normals: async () => (await import('../packages/cli/src/commands/normals.ts')).normalsCommand,
  pack: async () => (await import('../packages/cli/src/commands/pack.ts')).packCommand,
  render: async () => (await import('../packages/cli/src/commands/render.ts')).renderCommand,
  strokes: async () => (await import('../packages/cli/src/commands/strokes.ts')).strokesCommand,
  unpack: async () => (await import('../packages/cli/src/commands/unpack.ts')).unpackCommand,
  uv: async () => (await import('../packages/cli/src/commands/uv.ts')).uvCommand,
  validate: async () => (await import('../packages/cli/src/commands/validate.ts')).validateCommand,
  worker: async () => (await import('../packages/cli/src/batch/commands/worker.ts')).workerCommand,
} satisfies Record<string, () => Promise<Command>>

export type CommandName = keyof typeof COMMANDS
export const COMMAND_NAMES = Object.keys(COMMANDS) as CommandName[]

export function commandOf(name: CommandName): Promise<Command> {
  return COMMANDS[name]()
}

/** Runs `furrow NAME` as a user would. */
export async function runCommand(name: CommandName, ...words: string[]): Promise<void> {
  await (await commandOf(name)).parseAsync(words, { from: 'user' })
}
