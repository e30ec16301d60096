import { FurrowError } from 'furrow'
import { JsonReader } from 'furrow/internal'
import type { FailureKind, Job, Outcome } from './job.ts'
import { JOB_COMMAND_NAMES, JOB_COMMANDS } from './job-commands.ts'
import { manifestWords, parseJobOptions } from './job-options.ts'

/** Most characters of an address or a message. */
export const LONGEST = 2 ** 16
const MOST_WARNINGS = 10_000

const KINDS: readonly FailureKind[] = ['file', 'memory', 'time', 'crash', 'machine']

/**
 * Reads what came of a job, as a worker or a file of results tells it. Fields that are unknown are left out.
 *
 * @throws FurrowError that names the first field which is missing or wrong.
 */
export function parseOutcome(json: unknown, who: string): Outcome {
  const reader = new JsonReader(who)
  const fields = reader.object(json, 'a result')
  const { status, reason, kind, warnings, result, bytes, seconds, attempts, memory } = fields
  const count = (value: unknown, path: string) => reader.integer(value, path, 0, Number.MAX_SAFE_INTEGER)
  return {
    status: reader.choice(status, 'status', ['done', 'failed']),
    ...(status === 'failed' && {
      reason: reader.text(reason, 'reason', LONGEST),
      kind: reader.choice(kind, 'kind', KINDS),
    }),
    warnings: reader
      .array(warnings, 'warnings', 0, MOST_WARNINGS)
      .map((warning, i) => reader.text(warning, `warnings[${i}]`, LONGEST)),
    ...(result !== undefined && { result: reader.object(result, 'result') }),
    ...(bytes !== undefined && { bytes: count(bytes, 'bytes') }),
    seconds: reader.number(seconds, 'seconds', 0, Number.MAX_SAFE_INTEGER, 'seconds'),
    attempts: count(attempts, 'attempts'),
    ...(memory !== undefined && { memory: count(memory, 'memory') }),
  }
}

/**
 * Reads a job that a queue holds. Its options are those that a batch passes on, and no others.
 *
 * @throws FurrowError that names the first field which is missing or wrong.
 */
export function parseJob(json: unknown, who: string): Job {
  const reader = new JsonReader(who)
  const fields = reader.object(json, 'a job', ['key', 'command', 'input', 'identity', 'output', 'options'])
  const text = (name: 'key' | 'input' | 'identity' | 'output') => reader.text(fields[name], name, LONGEST)
  const command = reader.choice(fields.command, 'command', JOB_COMMAND_NAMES)
  const { writes } = JOB_COMMANDS[command]
  if (writes !== (fields.output !== undefined)) throw wrongOutput(fields.output, who)
  if (writes && !/\.(glb|vrm)$/i.test(text('output'))) throw wrongOutput(fields.output, who)
  return {
    key: text('key'),
    command,
    input: text('input'),
    identity: text('identity'),
    ...(writes && { output: text('output') }),
    options: parseJobOptions(command, manifestWords(fields.options, 'a job')),
  }
}

function wrongOutput(value: unknown, who: string): FurrowError {
  return new FurrowError({
    who,
    problem: 'output is not one of its command',
    value,
    limit: 'a .glb or .vrm for auto and pack, nothing for others',
    remedy: 'correct the job',
  })
}
