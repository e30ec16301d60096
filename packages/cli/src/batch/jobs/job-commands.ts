import type { Command } from 'commander'
import { autoCommand } from '../../commands/auto.ts'
import { inspectCommand } from '../../commands/inspect.ts'
import { packCommand } from '../../commands/pack.ts'
import { validateCommand } from '../../commands/validate.ts'

/** Command that a batch can run. */
export interface JobCommand {
  command: Command
  /** Kind of the input: a file, or a folder with all its contents. */
  reads: 'file' | 'folder'
  /** Whether the command writes a file; otherwise the result is its printed output. */
  writes: boolean
  /** Options whose values are files. The contents of these files are part of the job. */
  files: readonly string[]
  /** Reduces the printed JSON to the fields in the results. */
  summary: (printed: Record<string, unknown>) => Record<string, unknown>
}

/** Options that the batch sets itself, or that write more files; by attribute name. */
const EXCLUDED_OPTIONS = ['output', 'force', 'json', 'report', 'strokes', 'sheet']

const countOf = (list: unknown) => (Array.isArray(list) ? list.length : list)

/** Replaces layers and areas by their counts; `furrow inspect` shows the rest. */
const summarizeFace = ({ file, layers, areas, missing, warnings, ...rest }: Record<string, unknown>) => ({
  ...rest,
  layers: countOf(layers),
  areas: countOf(areas),
})

const withoutFile = ({ file, ...rest }: Record<string, unknown>) => rest

/** Commands that a batch can run. */
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

/** Returns the options of a command that can be given to the batch. */
export function passedOptions(name: JobCommandName) {
  return JOB_COMMANDS[name].command.options.filter((option) => {
    return !EXCLUDED_OPTIONS.includes(option.attributeName())
  })
}
