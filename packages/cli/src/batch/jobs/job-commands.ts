import type { Command } from 'commander'
import { autoCommand } from '../../commands/auto.ts'
import { inspectCommand } from '../../commands/inspect.ts'
import { packCommand } from '../../commands/pack.ts'
import { validateCommand } from '../../commands/validate.ts'

/** A command that is run on every input. */
export interface JobCommand {
  command: Command
  /** What it reads: a file, or a folder with all that is in it. */
  reads: 'file' | 'folder'
  /** Whether it makes a file; otherwise its result is what it prints. */
  writes: boolean
  /** Its options whose values are files: what is in them is part of the job. */
  files: readonly string[]
  /** What is kept of the JSON that it prints. */
  summary: (printed: Record<string, unknown>) => Record<string, unknown>
}

/** The options of commands that a batch sets itself, or that write further files; by attribute. */
const OWN = ['output', 'force', 'json', 'report', 'strokes', 'sheet']

const counted = (list: unknown) => (Array.isArray(list) ? list.length : list)

/** What is counted is enough of layers and areas: `furrow inspect` tells the rest from the file. */
const facesOnly = ({ file, layers, areas, missing, warnings, ...rest }: Record<string, unknown>) => ({
  ...rest,
  layers: counted(layers),
  areas: counted(areas),
})

const whole = ({ file, ...rest }: Record<string, unknown>) => rest

/** The commands of a batch. */
export const JOB_COMMANDS = {
  auto: { command: autoCommand, reads: 'file', writes: true, files: [], summary: facesOnly },
  pack: { command: packCommand, reads: 'folder', writes: true, files: ['face'], summary: facesOnly },
  validate: { command: validateCommand, reads: 'file', writes: false, files: [], summary: whole },
  inspect: { command: inspectCommand, reads: 'file', writes: false, files: [], summary: whole },
} as const satisfies Record<string, JobCommand>

export type JobCommandName = keyof typeof JOB_COMMANDS

export const JOB_COMMAND_NAMES = Object.keys(JOB_COMMANDS) as JobCommandName[]

export function isJobCommand(name: string): name is JobCommandName {
  return Object.hasOwn(JOB_COMMANDS, name)
}

/** The options of a command that a batch passes on. */
export function passedOptions(name: JobCommandName) {
  return JOB_COMMANDS[name].command.options.filter((option) => !OWN.includes(option.attributeName()))
}
