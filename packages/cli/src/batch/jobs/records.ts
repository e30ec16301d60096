import { FurrowError } from 'furrow'
import { JsonReader } from 'furrow/internal'
import type { FailureKind, Job, Outcome } from './job.ts'
import { JOB_COMMAND_NAMES, JOB_COMMANDS } from './job-commands.ts'
import { manifestWords, parseJobOptions } from './job-options.ts'

/** Maximum length of an address or a message, characters. */
export const MAX_TEXT_LENGTH = 2 ** 16
const MAX_WARNINGS = 10_000

const KINDS: readonly FailureKind[] = ['file', 'memory', 'time', 'crash', 'machine']

/**
 * Parses the result of a job, from a worker or a results file. Ignores unknown fields.
 *
 * @throws FurrowError for the first missing or invalid field.
 */
export function parseOutcome(json: unknown, who: string): Outcome {
  const reader = new JsonReader(who)
  const fields = reader.object(json, 'a result')
  const { status, reason, kind, warnings, result, bytes, seconds, attempts, memory } = fields
  const count = (value: unknown, path: string) => reader.integer(value, path, 0, Number.MAX_SAFE_INTEGER)
  return {
    status: reader.choice(status, 'status', ['done', 'failed']),
    ...(status === 'failed' && {
      reason: reader.text(reason, 'reason', MAX_TEXT_LENGTH),
      kind: reader.choice(kind, 'kind', KINDS),
    }),
    warnings: reader
      .array(warnings, 'warnings', 0, MAX_WARNINGS)
      .map((warning, i) => reader.text(warning, `warnings[${i}]`, MAX_TEXT_LENGTH)),
    ...(result !== undefined && { result: reader.object(result, 'result') }),
    ...(bytes !== undefined && { bytes: count(bytes, 'bytes') }),
    seconds: reader.number(seconds, 'seconds', 0, Number.MAX_SAFE_INTEGER, 'seconds'),
    attempts: count(attempts, 'attempts'),
    ...(memory !== undefined && { memory: count(memory, 'memory') }),
  }
}

/**
 * Parses a job from a queue. Accepts only options that users can pass through a batch.
 *
 * @throws FurrowError for the first missing or invalid field.
 */
export function parseJob(json: unknown, who: string): Job {
  const reader = new JsonReader(who)
  const fields = reader.object(json, 'a job', ['key', 'command', 'input', 'identity', 'output', 'options'])
  const text = (name: 'key' | 'input' | 'identity' | 'output') =>
    reader.text(fields[name], name, MAX_TEXT_LENGTH)
  const command = reader.choice(fields.command, 'command', JOB_COMMAND_NAMES)
  const { writes } = JOB_COMMANDS[command]
  if (writes !== (fields.output !== undefined)) throw invalidOutput(fields.output, who)
  if (writes && !/\.(glb|vrm)$/i.test(text('output'))) throw invalidOutput(fields.output, who)
  return {
    key: text('key'),
    command,
    input: text('input'),
    identity: text('identity'),
    ...(writes && { output: text('output') }),
    options: parseJobOptions(command, manifestWords(fields.options, 'a job')),
  }
}

function invalidOutput(value: unknown, who: string): FurrowError {
  return new FurrowError({
    who,
    problem: 'invalid output for the command',
    value,
    limit: '.glb or .vrm for auto and pack, none for other commands',
    remedy: 'correct the job',
  })
}
