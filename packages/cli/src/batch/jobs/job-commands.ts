import type { Command } from 'commander'
import { autoCommand } from '../../commands/auto.ts'
import { inspectCommand } from '../../commands/inspect.ts'
import { packCommand } from '../../commands/pack.ts'
import { validateCommand } from '../../commands/validate.ts'

/** Command that `furrow batch` can run on each input. */
export interface JobCommand {
  command: Command
  /** Whether an input is a file, or a folder with all its contents. */
  reads: 'file' | 'folder'
  /** Whether the command writes a file. Otherwise its result is the printed output. */
  writes: boolean
  /** Options whose values are paths of files. A job depends on the content of these files. */
  files: readonly string[]
  /** Returns the fields of the printed JSON that go into the results file. */
  summary: (printed: Record<string, unknown>) => Record<string, unknown>
}

/**
 * Options of the commands that `furrow batch` does not accept, by the names that commander's `Option.attributeName()`
 * returns. The batch sets some of them itself. The others would write additional files.
 */
const EXCLUDED_OPTIONS = ['output', 'force', 'json', 'report', 'strokes', 'sheet']

const countOf = (list: unknown) => (Array.isArray(list) ? list.length : list)

/**
 * Counts layers and areas instead of listing them, and drops skipped regions, to keep the results file small. Drops the
 * path and the warnings, because a line of the results has both in other fields.
 */
function summarizeFace(printed: Record<string, unknown>) {
  const { file, layers, areas, areasWithoutLines = [], missing, warnings, ...rest } = printed
  return { ...rest, layers: countOf(layers), areas: countOf([areas, areasWithoutLines].flat()) }
}

const withoutFile = ({ file, ...rest }: Record<string, unknown>) => rest

/** Commands that `furrow batch` can run. */
export const JOB_COMMANDS = {
  auto: { command: autoCommand, reads: 'file', writes: true, files: [], summary: summarizeFace },
  pack: { command: packCommand, reads: 'folder', writes: true, files: ['face'], summary: summarizeFace },
  validate: { command: validateCommand, reads: 'file', writes: false, files: [], summary: withoutFile },
  inspect: { command: inspectCommand, reads: 'file', writes: false, files: [], summary: withoutFile },
} as const satisfies Record<string, JobCommand>

export type JobCommandName = keyof typeof JOB_COMMANDS

export const JOB_COMMAND_NAMES = Object.keys(JOB_COMMANDS) as JobCommandName[]

export function isJobCommand(name: string): name is JobCommandName {
  return Object.hasOwn(JOB_COMMANDS, name)
}

/** Returns the options of a command that users can pass through a batch. */
export function passedOptions(name: JobCommandName) {
  return JOB_COMMANDS[name].command.options.filter((option) => {
    return !EXCLUDED_OPTIONS.includes(option.attributeName())
  })
}
